/// Finds candidate pairs of intersecting faces at vertices of high valence. The bounding boxes of n
/// thin faces around a vertex overlap each other in O(n^2) pairs, independent of the tree that
/// stores them. However, the projections of the faces of an embedded star (embedded_stars.h) are
/// sectors in order around the vertex. Binary search finds the sectors that another face spans, and
/// only their faces may meet this other face. Cost: O(n) to find the stars; O(log n + sectors) for
/// each face near a star. Deterministic.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"
#include "geometry/search/bvh.h"

namespace transformesh {

class HighValenceStars {
 public:
  /// Returns 1 for each point with such a high valence that find_simplex_links() (simplex_links.h)
  /// computed `links` for it. Returns an empty list if there are no links.
  static std::vector<char> crowded_points(const WeldedMesh& welded, const SimplexLinks& links);

  HighValenceStars() = default;
  /// Builds the stars of the points that are marked both in `is_embedded` (embedded_stars.h) and in
  /// `is_crowded` (high valence). A face at several such points belongs to the star of the point
  /// with the lowest index.
  HighValenceStars(const WeldedMesh& welded, std::span<const char> is_embedded,
                   std::span<const char> is_crowded);

  bool empty() const { return stars_.empty(); }
  bool has(Index face) const { return !empty() && star_of_[face] != no_index; }

  /// Returns all pairs of faces that may meet. The first kind of pair is a face of a star and a
  /// face in `others`, which must not belong to a star. The second kind is two faces of different
  /// stars. Each pair occurs once, with the lower face index first. The order of pairs is
  /// unspecified.
  std::vector<Bvh::Pair> find_pairs(std::span<const Index> others) const;

 private:
  /// The faces around a point, counter-clockwise in the projection along an axis.
  struct Star {
    Index center;
    PlaneProjection projection;
    std::vector<Index> faces;
    std::vector<Index> rim;     ///< for each face of the star its corner that follows the center
    std::vector<char> is_late;  ///< 1 for each face at an angle of pi or more from rim[0]
    FloatBox box;
  };
  /// A range of `count` consecutive sectors that starts at sector `first`, modulo the number of
  /// sectors of the star.
  struct Range {
    std::size_t first;
    std::size_t count;
  };

  void add(Index center, Index halfedge);
  bool is_ahead(const Star& star, Index from, Index to) const;
  std::size_t sector(const Star& star, Index point) const;
  Range sectors(const Star& star, const Face& face) const;
  void add_pairs(Index star_number, Index face, std::vector<Bvh::Pair>& pairs) const;

  const WeldedMesh* welded_ = nullptr;
  std::vector<Index> star_of_;   ///< star of each face, or no_index; empty if there are no stars
  std::vector<FloatBox> boxes_;  ///< box of each face
  std::vector<Star> stars_;
};

}  // namespace transformesh
