#include "clean/intersect/intersection_free_regions.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <optional>
#include <span>

#include "clean/intersect/projected_polygon.h"
#include "support/numbered_selection.h"
#include "support/parallel.h"
#include "transformesh/control.h"

namespace transformesh {
namespace {

/// Largest number of faces of a region. With larger regions, fewer faces have neighbors in other
/// regions, but the projected outlines of the regions intersect themselves more often. If the
/// outline of a large region intersects itself, regions of at most `small_region` faces are tried.
constexpr std::size_t large_region = 65536;
constexpr std::size_t small_region = 1024;

/// Number of blocks of consecutive faces per thread. With more blocks, more faces are at the
/// outlines of regions and have to be searched. With eight blocks, detection in two spheres of a
/// million faces takes a tenth longer on one thread. A choice.
constexpr std::size_t blocks_per_thread = 2;
/// Least number of faces of a block. In smaller blocks, starting a thread costs more than it saves.
constexpr std::size_t least_block = 32768;
/// Regions with fewer faces than this are discarded if the mesh is divided into several blocks. If
/// consecutive faces of the mesh are not neighbors, all regions within blocks are smaller. Then one
/// thread grows the regions in the whole mesh.
constexpr std::size_t least_in_block = 16;
constexpr std::size_t tested_faces_per_task = 8192;  ///< affects time only

/// The regions found so far. Several threads write to this object.
struct SharedRegions {
  explicit SharedRegions(const WeldedMesh& welded)
      : of_face(welded.faces.size(), no_index),
        is_seam(welded.points.size(), 0),
        is_region(welded.faces.size(), 0) {}
  void mark_seam(Index point) {
    std::atomic_ref(is_seam[point]).store(1, std::memory_order_relaxed);
  }
  /// Region of each face: the index of the face from which the region grew.
  std::vector<Index> of_face;
  std::vector<char> is_seam;    ///< 1 for each point on the outline of a region
  std::vector<char> is_region;  ///< 1 for each face that is the first face of a kept region
};

class RegionFinder {
 public:
  RegionFinder(const WeldedMesh& welded, SharedRegions& shared)
      : welded_(welded),
        across_(welded.opposites),
        directions_(welded.directions),
        region_of_(shared.of_face),
        shared_(shared),
        reached_in_(welded.points.size(), 0),
        outline_(welded.points) {}

  /// Finds regions of at least `least_faces` faces among the faces from `first` to before `last`
  /// that have no region. The regions start from the faces in `seeds`.
  void find(std::span<const Index> seeds, Index first, Index last, std::size_t least_faces) {
    first_ = first;
    last_ = last;
    least_faces_ = least_faces;
    has_failed_ = false;
    find_up_to(seeds, large_region);
    if (has_failed_) find_up_to(seeds, small_region);
  }

 private:
  bool is_inside(Index halfedge) const {
    return across_[halfedge] != no_index && has_face(across_[halfedge] / 3) &&
           region_of_[across_[halfedge] / 3] == region_;
  }
  bool has_face(Index face) const { return face >= first_ && face < last_; }

  void take(Index face) {
    region_of_[face] = region_;
    for (const Index corner : welded_.faces[face]) reached_in_[corner] = growth_;
    faces_.push_back(face);
  }

  // Adds the face at `halfedge` to the region. Skips a face if the region contains its third
  // corner, but neither of its other two edges. This face would create a hole.
  void try_to_take(Index halfedge) {
    const Index face = halfedge / 3;
    if (!has_face(face) || region_of_[face] != no_index) return;
    if ((directions_[face].leans & direction_) == 0) return;
    const Index next = next_halfedge(halfedge), previous = previous_halfedge(halfedge);
    const Index apex = welded_.faces[face][previous % 3];
    if (reached_in_[apex] == growth_ && !is_inside(next) && !is_inside(previous)) return;
    take(face);
  }

  void find_up_to(std::span<const Index> seeds, std::size_t most_faces) {
    for (const Index seed : seeds) {
      if (region_of_[seed] != no_index || directions_[seed].leans == 0) continue;
      grow(seed, most_faces);
      const bool is_large = faces_.size() > 1 && faces_.size() >= least_faces_;
      const bool is_region = is_large && has_simple_outline();
      has_failed_ |= !is_region && faces_.size() > small_region;
      shared_.is_region[seed] = is_region ? 1 : 0;
    }
    for (const Index face : seeds)
      if (region_of_[face] != no_index && !shared_.is_region[region_of_[face]])
        region_of_[face] = no_index;
  }

  // Adds faces in breadth-first order, which makes regions round.
  void grow(Index seed, std::size_t most_faces) {
    faces_.clear();
    region_ = seed;
    ++growth_;
    direction_ = static_cast<AxisDirections>(std::bit_floor(directions_[seed].leans));
    take(seed);
    for (std::size_t i = 0; i < faces_.size() && faces_.size() < most_faces; ++i)
      for (Index h = 3 * faces_[i]; h < 3 * faces_[i] + 3; ++h)
        if (across_[h] != no_index) try_to_take(across_[h]);
  }

  bool has_simple_outline() {
    outline_.clear();
    outline_points_.clear();
    for (const Index face : faces_)
      for (Index i = 0; i < 3; ++i) {
        if (is_inside(3 * face + i)) continue;
        const Index from = welded_.faces[face][i], to = welded_.faces[face][(i + 1) % 3];
        outline_points_.insert(outline_points_.end(), {from, to});
        outline_.add(from, to);
      }
    const int axis = std::countr_zero(direction_) / 2;
    if (!outline_.is_simple({(axis + 1) % 3, (axis + 2) % 3})) return false;
    for (const Index point : outline_points_) shared_.mark_seam(point);
    return true;
  }

  const WeldedMesh& welded_;
  std::span<const Index> across_;
  std::span<const FaceDirections> directions_;
  std::span<Index> region_of_;
  SharedRegions& shared_;
  /// For each point the value of `growth_` when a region last reached the point, or 0.
  std::vector<Index> reached_in_;
  Index growth_ = 0;            ///< number of regions grown so far, including discarded ones
  Index first_ = 0, last_ = 0;  ///< faces of regions are from `first_` to before `last_`
  std::size_t least_faces_ = 0;
  std::vector<Index> faces_;           ///< faces of the region that grows
  std::vector<Index> outline_points_;  ///< points on the outline of the region that grows
  Index region_ = 0;                   ///< first face of the region that grows
  AxisDirections direction_ = 0;
  bool has_failed_ = false;
  ProjectedPolygon outline_;
};

// Returns the number of blocks into which the faces are divided. For one thread this is 1.
std::size_t count_blocks(std::size_t faces) {
  const std::size_t threads = allowed_thread_count();
  return threads == 1
             ? 1
             : std::clamp(faces / least_block, std::size_t{1}, blocks_per_thread * threads);
}

// Finds regions in blocks of consecutive faces. Each thread repeatedly takes the next block.
void find_in_blocks(const WeldedMesh& welded, std::size_t blocks, SharedRegions& shared) {
  const std::size_t faces = welded.faces.size();
  std::atomic<std::size_t> next = 0;
  parallel_for(std::min(blocks, allowed_thread_count()), 1, [&](std::size_t, std::size_t) {
    std::optional<RegionFinder> finder;
    std::vector<Index> seeds;
    for (std::size_t block = next++; block < blocks; block = next++) {
      if (!finder) finder.emplace(welded, shared);
      const auto first = static_cast<Index>(block * faces / blocks);
      const auto last = static_cast<Index>((block + 1) * faces / blocks);
      seeds.resize(last - first);
      std::iota(seeds.begin(), seeds.end(), first);
      finder->find(seeds, first, last, blocks > 1 ? least_in_block : 0);
    }
  });
}

}  // namespace

IntersectionFreeRegions find_intersection_free_regions(const WeldedMesh& welded) {
  SharedRegions shared(welded);
  const auto faces = static_cast<Index>(welded.faces.size());
  const std::size_t blocks = count_blocks(faces);
  find_in_blocks(welded, blocks, shared);
  if (blocks > 1) {
    const auto rest = NumberedSelection(faces, [&](std::size_t f) {
                        return shared.of_face[f] == no_index && welded.directions[f].leans != 0;
                      }).list();
    if (!rest.empty()) RegionFinder(welded, shared).find(rest, 0, faces, 0);
  }
  parallel_for(faces, tested_faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      if (shared.of_face[f] == no_index)
        for (const Index corner : welded.faces[f]) shared.mark_seam(corner);
  });
  return {std::move(shared.of_face), std::move(shared.is_seam)};
}

}  // namespace transformesh
