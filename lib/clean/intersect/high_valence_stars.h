/// The faces around vertices of high valence, as a pie. The boxes of n thin faces around a vertex
/// overlap those of n others in O(n^2) pairs, however they are ordered in a tree. But seen along
/// the axis of an embedded star (embedded_stars.h) its faces are sectors in order around the
/// vertex. So binary search finds the sectors that another face spans, and only these may meet it.
/// Cost: O(n) to find the stars; O(log n + sectors) for each face near a star. Deterministic.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"
#include "geometry/search/bvh.h"

namespace transformesh {

class HighValenceStars {
 public:
  /// Points that are corners of so many faces that they have simplex links (simplex_links.h).
  static std::vector<char> crowded_points(const WeldedMesh& welded, const SimplexLinks& links);

  HighValenceStars() = default;
  /// The stars of the points that are marked both as embedded and as crowded. A face around several
  /// of them belongs to the lowest.
  HighValenceStars(const WeldedMesh& welded, std::span<const char> is_embedded,
                   std::span<const char> is_crowded);

  bool empty() const { return stars_.empty(); }
  bool has(Index face) const { return !empty() && star_of_[face] != no_index; }

  /// All pairs of a face of a star and a face, among `others` or of another star, that may meet.
  /// Each pair once, the lower face first, in no particular order. `others` are faces of no star.
  std::vector<Bvh::Pair> find_pairs(std::span<const Index> others) const;

 private:
  /// The faces around a point, counter-clockwise in the projection.
  struct Star {
    Index center;
    PlaneProjection projection;
    std::vector<Index> faces;
    std::vector<Index> rim;     ///< Per face, its corner that comes first.
    std::vector<char> is_late;  ///< Per face: the angle from rim[0] is pi or more.
    FloatBox box;
  };
  /// Sectors from `first` on, modulo their number.
  struct Range {
    std::size_t first;
    std::size_t count;
  };

  void add(Index center, Index halfedge);
  bool is_ahead(const Star& star, Index from, Index to) const;
  std::size_t sector(const Star& star, Index point) const;
  Range sectors(const Star& star, const Face& face) const;
  void add_pairs(Index star, Index face, std::vector<Bvh::Pair>& pairs) const;

  const WeldedMesh* welded_ = nullptr;
  std::vector<Index> star_of_;   ///< per face; no_index for none; empty without stars
  std::vector<FloatBox> boxes_;  ///< per face
  std::vector<Star> stars_;
};

}  // namespace transformesh
