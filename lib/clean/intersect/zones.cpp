#include "clean/intersect/zones.h"

#include <bit>

#include "clean/intersect/projected_polygon.h"

namespace transformesh {
namespace {

/// Faces at most. The larger the zones, the fewer neighbors are in different ones; but their
/// outlines cross more easily, and where they do, smaller ones are tried.
constexpr std::size_t large_zone = 65536;
constexpr std::size_t small_zone = 1024;

class ZoneFinder {
 public:
  explicit ZoneFinder(const WeldedMesh& welded)
      : welded_(welded),
        across_(welded.opposites),
        ways_(welded.ways),
        zone_of_(welded.faces.size(), no_index),
        is_seam_(welded.points.size(), 0),
        reached_by_(welded.points.size(), no_index),
        outline_(welded.points) {}

  Zones run() {
    find_up_to(large_zone);
    if (has_failed_) find_up_to(small_zone);
    for (std::size_t f = 0; f < zone_of_.size(); ++f)
      if (zone_of_[f] == no_index)
        for (const Index corner : welded_.faces[f]) is_seam_[corner] = 1;
    return {std::move(zone_of_), std::move(is_seam_)};
  }

 private:
  Index zone() const { return static_cast<Index>(is_zone_.size()); }
  bool is_inside(Index halfedge) const {
    return across_[halfedge] != no_index && zone_of_[across_[halfedge] / 3] == zone();
  }

  void take(Index face) {
    zone_of_[face] = zone();
    for (const Index corner : welded_.faces[face]) reached_by_[corner] = zone();
    faces_.push_back(face);
  }

  // A face that the zone reaches at a corner only would make a hole, and is not taken.
  void try_to_take(Index halfedge) {
    const Index face = halfedge / 3;
    if (zone_of_[face] != no_index || (ways_[face].leans & way_) == 0) return;
    const Index next = next_halfedge(halfedge), previous = previous_halfedge(halfedge);
    const Index apex = welded_.faces[face][previous % 3];
    if (reached_by_[apex] == zone() && !is_inside(next) && !is_inside(previous)) return;
    take(face);
  }

  void find_up_to(std::size_t most_faces) {
    for (Index face = 0; face < zone_of_.size(); ++face) {
      if (zone_of_[face] != no_index || ways_[face].leans == 0) continue;
      grow(face, most_faces);
      const bool is_zone = faces_.size() > 1 && has_simple_outline();
      has_failed_ |= !is_zone && faces_.size() > small_zone;
      is_zone_.push_back(is_zone ? 1 : 0);
    }
    for (Index& zone : zone_of_)
      if (zone != no_index && !is_zone_[zone]) zone = no_index;
  }

  // From face to face, so that zones become round.
  void grow(Index seed, std::size_t most_faces) {
    faces_.clear();
    way_ = static_cast<Ways>(std::bit_floor(ways_[seed].leans));
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
    const int axis = std::countr_zero(way_) / 2;
    return outline_.is_simple({(axis + 1) % 3, (axis + 2) % 3});
  }

  const WeldedMesh& welded_;
  std::span<const Index> across_;
  std::span<const FaceWays> ways_;
  std::vector<Index> zone_of_;
  std::vector<char> is_seam_;
  std::vector<Index> reached_by_;  ///< per point the last zone that has
  std::vector<Index> faces_;       ///< of the zone that grows
  Ways way_ = 0;
  std::vector<char> is_zone_;
  bool has_failed_ = false;
  ProjectedPolygon outline_;
};

}  // namespace

Zones find_zones(const WeldedMesh& welded) { return ZoneFinder(welded).run(); }

}  // namespace transformesh
