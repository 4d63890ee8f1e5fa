/// Outlines of flat regions after removing vertices inside the regions and on straight edges.
///
/// A vertex is removed if all its faces belong to regions, and one of two conditions holds. The
/// vertex is inside a region, or it is on a straight edge between two regions or between a region
/// and a border. Vertices at the position of another vertex stay, because sheets touch there. Edges
/// between such vertices also stay. A chain of vertices between two regions is replaced by as few
/// segments as the tolerance permits. Reference: Douglas & Peucker, "Algorithms for the reduction
/// of the number of points required to represent a digitized line or its caricature", Cartographica
/// 10(2), 1973. Departure: each vertex has its own tolerance. Deterministic. Cost: O(n log n) on
/// usual outlines.
#pragma once

#include <span>
#include <vector>

#include "clean/flat/flat_regions.h"

namespace transformesh {

/// The surface whose regions are simplified.
struct FlatSurface {
  const Mesh& mesh;
  std::span<const Index> opposites;
  std::span<const char> has_copy;  ///< 1 for each vertex with the position of another vertex
  double spacings;                 ///< tolerance in spacings of type `coordinate`
  Scalar coordinate;
};

/// Remainder of a region after removing vertices.
struct RegionOutlines {
  /// Each outline has the region on its left. An inner edge that stays is an outline of two
  /// vertices, an inner vertex that stays is an outline of one.
  std::vector<std::vector<Index>> outlines;
  std::size_t faces = 0;  ///< number of faces in any triangulation of the outlines
};

/// Determines which vertices are removed, and how far the straight edges move.
class FlatOutlines {
 public:
  /// Faces without region in `of_face` do not change.
  FlatOutlines(const FlatSurface& surface, std::span<const Index> of_face);

  RegionOutlines of(const FlatRegion& region);
  /// True if a vertex of the region is removed.
  bool changes(const FlatRegion& region) const;
  bool goes(Index vertex) const { return goes_[vertex] != 0; }
  /// Returns the largest distance of a removed vertex from the segment that replaces it.
  double movement() const { return movement_; }

 private:
  enum Place : char { nowhere, inside, on_edge, corner };

  void find_places();
  void straighten_edges();
  void begin_at_corner(std::vector<Index>& row) const;
  void straighten(const std::vector<Index>& row);
  std::vector<Index> row_from(Index halfedge) const;
  Index next_around(Index halfedge) const;
  Index region_across(Index halfedge) const;
  bool is_outline(Index halfedge) const;
  void follow(Index halfedge, RegionOutlines& found);

  const FlatSurface& surface_;
  std::span<const Index> of_face_;
  std::vector<Place> places_;      ///< place of each vertex
  std::vector<char> goes_;         ///< 1 for each vertex that is removed
  std::vector<char> is_followed_;  ///< 1 for each halfedge on an outline that was visited
  double movement_ = 0;
};

}  // namespace transformesh
