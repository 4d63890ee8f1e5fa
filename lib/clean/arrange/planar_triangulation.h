/// Constrained triangulation of exact points in one plane, inside a large scaffold triangle (the
/// constrained 2D Delaunay triangulation of paper 3.2.3). Constraints may intersect each other and
/// pass through points. An intersection of two constraints becomes a point, which the caller
/// computes from the definitions of both lines. All orientation tests are exact.
///
/// Constraints are inserted by edge flips as in Sloan, "A fast algorithm for generating constrained
/// Delaunay triangulations", Computers & Structures 1993. Unlike Sloan's algorithm, this one splits
/// constraints that intersect.
///
/// Cost: in the worst case, O(k) per inserted point if the triangulation has k facets.
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
    std::array<Index, 3> v;     ///< corners, counter-clockwise in the projection
    std::array<Index, 3> next;  ///< facet across the edge from v[i] to v[i + 1], or no_index
    std::array<Index, 3> line;  ///< list of the constraints on the edge from v[i], or no_index
  };
  /// A constraint on an edge. `is_along` is true if the edge has the direction of the constraint.
  struct OnEdge {
    Index line;
    bool is_along;
    bool operator==(const OnEdge&) const = default;
  };
  /// Computes the intersection of two constraint lines.
  using Crossing = std::function<ExactPoint(Index first_line, Index second_line)>;

  /// `plane` is a triangle in the plane. The box [low, high] must contain all points.
  PlanarTriangulation(const ExactGeometry& geometry, const Triangle& plane, const Vec3& low,
                      const Vec3& high, Crossing crossing);

  /// Starts with the triangle of the plane. For planes in which no other triangle is cut. Must be
  /// called before any insertion. The corners become points 3, 4 and 5; the edges become lines 0, 1
  /// and 2. Returns false and changes nothing if the scaffold around the triangle cannot be
  /// represented in doubles.
  bool begin_with_triangle(const std::array<ExactPoint, 3>& corners);
  /// Inserts a point that is on the given lines. Returns its index, or the index of an equal point.
  Index insert(const ExactPoint& point, std::span<const Index> lines);
  Index insert(const ExactPoint& point, std::initializer_list<Index> lines) {
    return insert(point, std::span<const Index>(lines.begin(), lines.size()));
  }
  /// Records further lines that contain a point.
  void add_lines(Index point, std::span<const Index> lines) {
    for (const Index line : lines) add_line(point, line);
  }
  /// Makes the segment a chain of constrained edges. Both end points must lie on the line.
  void constrain(Index from, Index to, Index line);
  /// Flips unconstrained edges until the triangulation is constrained Delaunay. If both diagonals
  /// are equally good, the diagonal at the point with the least defining vertices stays. Hence the
  /// result depends neither on other insertions nor on the order of the faces. If `marked` is not
  /// empty, only edges of marked facets are flipped; constraints must separate marked from unmarked
  /// facets.
  void improve(const std::vector<char>& marked = {});
  /// Calls `visit` for each constraint on an edge of a facet.
  template <class Visit>
  void for_each_line(Index facet, Index i, const Visit& visit) const {
    bool is_along = true;
    for (Index at = facets_[facet].line[i]; at != no_index; at = lists_[at / 2].rest) {
      is_along ^= at % 2 == 1;
      visit(OnEdge{lists_[at / 2].line, is_along});
    }
  }
  /// Returns the edges (3 * facet + i) from one point to another along a constraint, or against its
  /// direction.
  std::vector<Index> chain(Index from, Index to, OnEdge along) const;
  /// The marked facets, sorted by the definitions of their points.
  struct Collection {
    std::vector<ExactPoint> points;  ///< points in the order in which `facets` refers to them
    /// Corners of the facets; each facet starts with its least corner.
    std::vector<Face> facets;
    std::vector<Index> numbers;  ///< index of each facet in facets()
  };
  Collection collect(const std::vector<char>& marked) const;

  const std::vector<Facet>& facets() const { return facets_; }
  const ExactPoint& point(Index i) const { return points_[i]; }
  std::size_t point_count() const { return points_.size(); }
  /// Returns the first point of an edge (3 * facet + i).
  Index source(Index edge) const { return facets_[edge / 3].v[edge % 3]; }
  /// Number of leading points that are corners of the scaffold.
  static constexpr Index scaffold_points = 3;

 private:
  using Lines = boost::container::small_vector<Index, 4>;
  struct Segment {
    Index from, to, line;
  };
  struct Location {
    Index facet;
    /// Orientation of the point with each edge: 0 if the point is on the edge; two zeros if it is a
    /// corner.
    std::array<int, 3> side;
  };
  /// Linked list of the constraints on an edge. The parts of a split edge share one list. List `i`
  /// has the number 2 i for the edge direction and 2 i + 1 for the opposite direction.
  struct ListOnEdge {
    Index line;
    Index rest;    ///< number of the list of the remaining constraints, or no_index
    Index oldest;  ///< the line that was added to the list first
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
  std::vector<Lines> lines_;     ///< lines through each point, ascending
  std::vector<Index> facet_of_;  ///< one facet at each point
  std::vector<Facet> facets_;
  std::vector<ListOnEdge> lists_;
};

}  // namespace transformesh
