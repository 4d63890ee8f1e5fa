/// A constrained triangulation of exact points in one plane, inside a large scaffold triangle (the
/// constrained 2D Delaunay triangulation of paper 3.2.3). Constraints may cross each other and pass
/// through points: crossings become points, supplied by the caller from the definitions of both
/// lines. Every decision is exact.
/// Reference for constraints by flips: Sloan, "A fast algorithm for generating constrained Delaunay
/// triangulations", Computers & Structures 1993.
#pragma once

#include <boost/container/small_vector.hpp>
#include <functional>
#include <span>
#include <vector>

#include "geometry/numbers/exact_point.h"

namespace transformesh {

class PlanarTriangulation {
 public:
  struct Facet {
    std::array<Index, 3> v;     ///< points, counter-clockwise in the projection
    std::array<Index, 3> next;  ///< the facet across the edge from v[i] to v[i + 1]
    std::array<Index, 3> line;  ///< the constraints on that edge as a list, or no_index
  };
  /// A constraint on an edge: `is_along` if the edge has the direction in which it was constrained.
  struct OnEdge {
    Index line;
    bool is_along;
    bool operator==(const OnEdge&) const = default;
  };
  /// The point where two constraint lines cross.
  using Crossing = std::function<ExactPoint(Index first_line, Index second_line)>;

  /// `plane` spans the plane; [low, high] contains all points that will come.
  PlanarTriangulation(const ExactGeometry& geometry, const Triangle& plane, const Vec3& low,
                      const Vec3& high, Crossing crossing);

  /// Inserts the triangle of the plane, the whole of what is cut, before anything else: its corners
  /// become the points 3, 4 and 5, and its edges the lines 0, 1 and 2. Returns whether that was
  /// simple; if not, nothing was done.
  bool begin_with_triangle(const std::array<ExactPoint, 3>& corners);
  /// Returns the index of the point, or of an equal one that is there. It is known to be on the
  /// given lines.
  Index insert(const ExactPoint& point, std::span<const Index> lines);
  Index insert(const ExactPoint& point, std::initializer_list<Index> lines) {
    return insert(point, std::span<const Index>(lines.begin(), lines.size()));
  }
  /// Adds lines on which a point is known to be.
  void add_lines(Index point, std::span<const Index> lines) {
    for (const Index line : lines) add_line(point, line);
  }
  /// Makes the segment a chain of constrained edges. Both ends are on the line.
  void constrain(Index from, Index to, Index line);
  /// Flips diagonals that no constraint holds until they are Delaunay; of two that are equally good
  /// the one at the point with the least defining vertices stays. So the result depends neither on
  /// what else was inserted nor on the order of the faces. Constraints bound what is marked per
  /// facet, if anything is; the rest is left as it is.
  void improve(const std::vector<char>& marked = {});
  /// The constraints on an edge of a facet.
  template <class Visit>
  void for_each_line(Index facet, Index i, const Visit& visit) const {
    bool is_along = true;
    for (Index at = facets_[facet].line[i]; at != no_index; at = lists_[at / 2].rest) {
      is_along ^= at % 2 == 1;
      visit(OnEdge{lists_[at / 2].line, is_along});
    }
  }
  /// The edges (facet * 3 + i) from one point along a constraint, or against it, to another.
  std::vector<Index> chain(Index from, Index to, OnEdge along) const;
  /// The marked facets in the order of their points' definitions, and by these.
  struct Collection {
    std::vector<ExactPoint> points;  ///< in the order in which the facets name them
    std::vector<Face> facets;        ///< each begins with the least
    std::vector<Index> numbers;      ///< in facets()
  };
  Collection collect(const std::vector<char>& marked) const;

  const std::vector<Facet>& facets() const { return facets_; }
  const ExactPoint& point(Index i) const { return points_[i]; }
  std::size_t point_count() const { return points_.size(); }
  /// Where an edge starts.
  Index source(Index edge) const { return facets_[edge / 3].v[edge % 3]; }
  static constexpr Index scaffold_points = 3;  ///< the first points are the scaffold

 private:
  using Lines = boost::container::small_vector<Index, 4>;
  struct Segment {
    Index from, to, line;
  };
  struct Location {
    Index facet;
    std::array<int, 3> side;  ///< of each edge on which the point is; two zeros: at a corner
  };
  /// A list of the constraints on an edge. Lists are shared by the parts of an edge that was split.
  /// The number of list i is 2 i along the edge, and 2 i + 1 from its other side.
  struct ListOnEdge {
    Index line;
    Index rest;    ///< a list, or no_index
    Index oldest;  ///< the line that was there first
  };

  int orientation(Index a, Index b, Index c) const;
  int side_of(const Segment& segment, Index point) const;
  std::span<const Index> lines_of(Index point) const {
    return {lines_[point].data(), lines_[point].size()};
  }
  static bool share_line(std::span<const Index> a, std::span<const Index> b,
                         std::span<const Index> c);
  bool is_ahead(Index from, Index through, Index to) const;
  Location locate(const ExactPoint& point, std::span<const Index> lines) const;
  Index add_point(const ExactPoint& point);
  void add_line(Index point, Index line);
  void set_facet(Index facet, const std::array<Index, 3>& v, const std::array<Index, 3>& next,
                 const std::array<Index, 3>& line);
  void split_facet(Index facet, Index point);
  void split_edge(Index edge, Index point);
  Index flip(Index edge);
  bool is_convex(Index edge) const;
  bool wants_flip(Index edge, bool breaks_ties) const;
  bool is_before(Index a, Index b) const { return points_[a].definition < points_[b].definition; }
  void legalize(Index point);
  Index edge_between(Index from, Index to) const;
  void mark(Index edge, Index line);
  Index step_along(const Segment& segment);
  Index march(Index edge, const Segment& segment);
  void clear_way(std::vector<std::array<Index, 2>> crossed, const Segment& segment);
  Index opposite(Index edge) const;
  Index target(Index edge) const;
  template <class Accept>
  Index find_edge_from(Index point, const Accept& accept) const;

  const ExactGeometry& geometry_;
  PlaneProjection projection_;
  Crossing crossing_;
  std::vector<ExactPoint> points_;
  std::vector<Lines> lines_;     ///< through each point, ascending
  std::vector<Index> facet_of_;  ///< some facet at each point
  std::vector<Facet> facets_;
  std::vector<ListOnEdge> lists_;
};

}  // namespace transformesh
