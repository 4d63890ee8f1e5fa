/// Candidate pairs at vertices of high valence. The boxes of n thin faces around a vertex overlap
/// each other in O(n^2) pairs, independent of the tree that stores them. However, in the projection
/// along the axis of an embedded star (embedded_stars.h), the faces are sectors in order around the
/// vertex. Binary search finds the sectors that another face spans, and only these may meet the
/// face. Cost: O(n) to find the stars; O(log n + sectors) for each face near a star. Deterministic.
#pragma once

#include <span>
#include <vector>

#include "clean/intersect/welded_mesh.h"
#include "geometry/search/bvh.h"

namespace transformesh {

class HighValenceStars {
 public:
  /// Returns 1 for each point whose valence is so high that it has a simplex link
  /// (simplex_links.h). Returns an empty list if there are no links.
  static std::vector<char> crowded_points(const WeldedMesh& welded, const SimplexLinks& links);

  HighValenceStars() = default;
  /// Builds the stars of the points that are marked both as embedded and as crowded. A face around
  /// several such points belongs to the star of the point with the lowest index.
  HighValenceStars(const WeldedMesh& welded, std::span<const char> is_embedded,
                   std::span<const char> is_crowded);

  bool empty() const { return stars_.empty(); }
  bool has(Index face) const { return !empty() && star_of_[face] != no_index; }

  /// Returns all pairs that may meet, of a face of a star and either a face in `others` or a face
  /// of another star. Each pair occurs once, with the lower face first; the order of pairs is
  /// unspecified. Faces in `others` must not belong to a star.
  std::vector<Bvh::Pair> find_pairs(std::span<const Index> others) const;

 private:
  /// The faces around a point, counter-clockwise in the projection.
  struct Star {
    Index center;
    PlaneProjection projection;
    std::vector<Index> faces;
    std::vector<Index> rim;     ///< for each face its first corner after the center
    std::vector<char> is_late;  ///< 1 for each face at an angle of pi or more from rim[0]
    FloatBox box;
  };
  /// A range of `count` sectors from `first` on, modulo the number of sectors.
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
  std::vector<Index> star_of_;   ///< star of each face, or no_index; empty if there are no stars
  std::vector<FloatBox> boxes_;  ///< box of each face
  std::vector<Star> stars_;
};

}  // namespace transformesh
