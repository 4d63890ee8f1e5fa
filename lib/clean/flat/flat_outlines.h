/// The outlines that flat regions have once vertices on straight edges are gone.
///
/// A vertex goes where only faces of regions meet, if it lies inside of one, or on a straight edge
/// between two, or between one and a border. Vertices stay at which copies lie, and edges between
/// such vertices: there sheets touch. Rows of vertices between two regions become as few segments
/// as stay within the tolerance of each. Reference: Douglas & Peucker, "Algorithms for the
/// reduction of the number of points required to represent a digitized line or its caricature",
/// Cartographica 10(2), 1973. Deterministic. Cost: O(n log n).
#pragma once

#include <span>
#include <vector>

#include "clean/flat/flat_regions.h"

namespace transformesh {

/// The surface of which regions are given up.
struct FlatSurface {
  const Mesh& mesh;
  std::span<const Index> opposites;
  std::span<const char> has_copy;  ///< per vertex: whether another one has its position
  double spacings;                 ///< the tolerance, in those of `coordinate`
  Scalar coordinate;
};

/// What is left of a region.
struct RegionOutlines {
  /// The region has them on its left. Edges inside come as outlines of two vertices, single
  /// vertices inside as outlines of one.
  std::vector<std::vector<Index>> outlines;
  std::size_t faces = 0;  ///< their number in any triangulation of the same topology
};

/// Finds which vertices go, and how far the straight edges move.
class FlatOutlines {
 public:
  /// Regions whose number is not in `of_face` keep their faces.
  FlatOutlines(const FlatSurface& surface, std::span<const Index> of_face);

  RegionOutlines of(const FlatRegion& region);
  /// Whether a vertex of the region goes.
  bool changes(const FlatRegion& region) const;
  bool goes(Index vertex) const { return goes_[vertex] != 0; }
  /// The largest distance of a vertex that goes from the segment that is left in its place.
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
  std::vector<Place> places_;      ///< per vertex
  std::vector<char> goes_;         ///< per vertex
  std::vector<char> is_followed_;  ///< per halfedge of an outline
  double movement_ = 0;
};

}  // namespace transformesh
