/// Computes the outlines of flat regions (flat_regions.h) after removing vertices inside the
/// regions and on straight edges of the outlines.
///
/// A vertex is removed if all its faces belong to regions, and one of two conditions holds. The
/// vertex is inside a region, or it is on a straight edge between two regions or between a region
/// and a border. Vertices at the position of another vertex stay, because sheets touch there. Edges
/// between such vertices also stay. A chain of vertices between two regions is replaced by few
/// segments within the tolerance. Reference: Douglas & Peucker, "Algorithms for the reduction of
/// the number of points required to represent a digitized line or its caricature", Cartographica
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
  /// 1 for each vertex whose position is also the position of another vertex.
  std::span<const char> has_copy;
  double spacings;  ///< tolerance, in spacings of numbers of type `coordinate`
  Scalar coordinate;
};

/// The outlines of a region after removing vertices.
struct RegionOutlines {
  /// Closed chains of vertices, with the region on their left. An edge inside the region that stays
  /// is an outline of two vertices. A vertex inside the region that stays is an outline of one
  /// vertex.
  std::vector<std::vector<Index>> outlines;
  std::size_t faces = 0;  ///< number of faces in any triangulation of the outlines
};

/// Determines which vertices are removed, and how far the outlines move.
class FlatOutlines {
 public:
  /// `of_face` has the region of each face. Faces with no_index there do not change.
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
  std::vector<Place> places_;      ///< place of each vertex relative to the regions
  std::vector<char> goes_;         ///< 1 for each vertex that is removed
  std::vector<char> is_followed_;  ///< 1 for each visited halfedge of an outline
  double movement_ = 0;
};

}  // namespace transformesh
