/// A constrained triangulation of exact points in one plane, inside a large scaffold triangle (the
/// constrained 2D Delaunay triangulation of paper 3.2.3). Constraints may cross each other and pass
/// through points: crossings become points, supplied by the caller from the definitions of both
/// lines. Every decision about topology is exact. The choice between two valid diagonals (Delaunay,
/// by angles in doubles) is not: it makes triangles well shaped where constraints allow.
/// Reference for constraints by flips: Sloan, "A fast algorithm for generating constrained Delaunay
/// triangulations", Computers & Structures 1993.
#pragma once

#include <functional>
#include <vector>

#include "tm/geometry/exact_point.h"

namespace transformesh {

class PlanarTriangulation {
 public:
  struct Facet {
    std::array<Index, 3> v;     ///< points, counter-clockwise in the projection
    std::array<Index, 3> next;  ///< the facet across the edge from v[i] to v[i + 1]
    std::array<Index, 3> line;  ///< the constraint on that edge, or no_index
  };
  /// The point where two constraint lines cross.
  using Crossing = std::function<ExactPoint(Index first_line, Index second_line)>;

  /// `plane` spans the plane; [low, high] contains all points that will come.
  PlanarTriangulation(const ExactGeometry& geometry, const Triangle& plane, const Vec3& low,
                      const Vec3& high, Crossing crossing);

  /// Returns the index of the point, or of an equal one that is there. It is known to be on the
  /// given lines.
  Index insert(const ExactPoint& point, std::initializer_list<Index> lines);
  /// Makes the segment a chain of constrained edges. Both ends are on the line.
  void constrain(Index from, Index to, Index line);
  /// Flips diagonals that no constraint holds until they are Delaunay.
  void improve();
  /// The edges (facet * 3 + i) from one point straight to another; they must exist.
  std::vector<Index> chain(Index from, Index to) const;

  const std::vector<Facet>& facets() const { return facets_; }
  const ExactPoint& point(Index i) const { return points_[i]; }
  std::size_t point_count() const { return points_.size(); }
  static constexpr Index scaffold_points = 3;  ///< the first points are the scaffold

 private:
  struct Location {
    Index facet;
    std::array<int, 3> side;  ///< of each edge on which the point is; two zeros: at a corner
  };

  int orientation(Index a, Index b, Index c) const;
  int orientation(Index a, Index b, const ExactPoint& c) const;
  bool is_ahead(Index from, Index through, Index to) const;
  Location locate(const ExactPoint& point) const;
  Index add_point(const ExactPoint& point);
  void add_line(Index point, Index line);
  void set_facet(Index facet, const std::array<Index, 3>& v, const std::array<Index, 3>& next,
                 const std::array<Index, 3>& line);
  void split_facet(Index facet, Index point);
  void split_edge(Index edge, Index point);
  Index flip(Index edge);
  bool is_convex(Index edge) const;
  bool wants_flip(Index edge) const;
  void legalize(Index point);
  Index edge_between(Index from, Index to) const;
  void mark(Index edge, Index line);
  Index step_along(Index from, Index to, Index line);
  Index march(Index edge, Index from, Index to, Index line);
  void clear_way(std::vector<std::array<Index, 2>> crossed, Index from, Index to);
  Index opposite(Index edge) const;
  Index target(Index edge) const;
  template <class Accept>
  Index find_edge_from(Index point, const Accept& accept) const;

  const ExactGeometry& geometry_;
  PlaneProjection projection_;
  Crossing crossing_;
  std::vector<ExactPoint> points_;
  std::vector<std::vector<Index>> lines_;  ///< through each point, ascending
  std::vector<Index> facet_of_;            ///< some facet at each point
  std::vector<Facet> facets_;
};

}  // namespace transformesh
