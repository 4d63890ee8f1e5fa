#include "clean/intersect/intersection_free_regions.h"

#include <bit>

#include "clean/intersect/projected_polygon.h"

namespace transformesh {
namespace {

/// Largest number of faces of a region. Larger regions have fewer neighbors in other regions, but
/// their outlines intersect themselves more often. If the outline of a large region intersects
/// itself, regions of at most `small_region` faces are tried.
constexpr std::size_t large_region = 65536;
constexpr std::size_t small_region = 1024;

class RegionFinder {
 public:
  explicit RegionFinder(const WeldedMesh& welded)
      : welded_(welded),
        across_(welded.opposites),
        directions_(welded.directions),
        region_of_(welded.faces.size(), no_index),
        is_seam_(welded.points.size(), 0),
        reached_by_(welded.points.size(), no_index),
        outline_(welded.points) {}

  IntersectionFreeRegions run() {
    find_up_to(large_region);
    if (has_failed_) find_up_to(small_region);
    for (std::size_t f = 0; f < region_of_.size(); ++f)
      if (region_of_[f] == no_index)
        for (const Index corner : welded_.faces[f]) is_seam_[corner] = 1;
    return {std::move(region_of_), std::move(is_seam_)};
  }

 private:
  Index region() const { return static_cast<Index>(is_region_.size()); }
  bool is_inside(Index halfedge) const {
    return across_[halfedge] != no_index && region_of_[across_[halfedge] / 3] == region();
  }

  void take(Index face) {
    region_of_[face] = region();
    for (const Index corner : welded_.faces[face]) reached_by_[corner] = region();
    faces_.push_back(face);
  }

  // Adds the face at `halfedge` to the region. A face that the region already touches at the
  // opposite corner only would create a hole, and is skipped.
  void try_to_take(Index halfedge) {
    const Index face = halfedge / 3;
    if (region_of_[face] != no_index || (directions_[face].leans & direction_) == 0) return;
    const Index next = next_halfedge(halfedge), previous = previous_halfedge(halfedge);
    const Index apex = welded_.faces[face][previous % 3];
    if (reached_by_[apex] == region() && !is_inside(next) && !is_inside(previous)) return;
    take(face);
  }

  void find_up_to(std::size_t most_faces) {
    for (Index face = 0; face < region_of_.size(); ++face) {
      if (region_of_[face] != no_index || directions_[face].leans == 0) continue;
      grow(face, most_faces);
      const bool is_region = faces_.size() > 1 && has_simple_outline();
      has_failed_ |= !is_region && faces_.size() > small_region;
      is_region_.push_back(is_region ? 1 : 0);
    }
    for (Index& region : region_of_)
      if (region != no_index && !is_region_[region]) region = no_index;
  }

  // Adds faces in breadth-first order, which makes regions round.
  void grow(Index seed, std::size_t most_faces) {
    faces_.clear();
    direction_ = static_cast<AxisDirections>(std::bit_floor(directions_[seed].leans));
    take(seed);
    for (std::size_t i = 0; i < faces_.size() && faces_.size() < most_faces; ++i)
      for (Index h = 3 * faces_[i]; h < 3 * faces_[i] + 3; ++h)
        if (across_[h] != no_index) try_to_take(across_[h]);
  }

  bool has_simple_outline() {
    outline_.clear();
    for (const Index face : faces_)
      for (Index i = 0; i < 3; ++i) {
        if (is_inside(3 * face + i)) continue;
        const Index from = welded_.faces[face][i], to = welded_.faces[face][(i + 1) % 3];
        is_seam_[from] = is_seam_[to] = 1;
        outline_.add(from, to);
      }
    const int axis = std::countr_zero(direction_) / 2;
    return outline_.is_simple({(axis + 1) % 3, (axis + 2) % 3});
  }

  const WeldedMesh& welded_;
  std::span<const Index> across_;
  std::span<const FaceDirections> directions_;
  std::vector<Index> region_of_;
  std::vector<char> is_seam_;
  std::vector<Index> reached_by_;  ///< for each point the last region with a face at that point
  std::vector<Index> faces_;       ///< faces of the region that grows
  AxisDirections direction_ = 0;
  std::vector<char> is_region_;
  bool has_failed_ = false;
  ProjectedPolygon outline_;
};

}  // namespace

IntersectionFreeRegions find_intersection_free_regions(const WeldedMesh& welded) {
  return RegionFinder(welded).run();
}

}  // namespace transformesh
