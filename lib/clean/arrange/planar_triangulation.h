/// Constrained triangulation of exact points in one plane, inside a large scaffold triangle (the
/// constrained 2D Delaunay triangulation of paper 3.2.3). Facets are the triangles. A constraint is
/// a segment of a line, and has the number of this line. Constraints may intersect each other and
/// pass through points. An intersection of two constraints becomes a point, which a function of the
/// caller computes from the numbers of both lines. All orientation tests are exact.
///
/// Constraints are inserted by edge flips as in Sloan, "A fast algorithm for generating constrained
/// Delaunay triangulations", Computers & Structures 1993. Unlike Sloan's algorithm, this one splits
/// constraints that intersect.
///
/// Cost per inserted point in a triangulation of k facets: O(k) in the worst case.
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
    /// Number of the list of the constraints on the edge from v[i] to v[i + 1], or no_index.
    std::array<Index, 3> line;
  };
  /// A constraint on an edge of a facet. `is_along` is true if the edge has the direction of the
  /// constraint.
  struct OnEdge {
    Index line;
    bool is_along;
    bool operator==(const OnEdge&) const = default;
  };
  /// Function that computes the intersection of two lines, given by their numbers.
  using Crossing = std::function<ExactPoint(Index first_line, Index second_line)>;
  /// Function that returns a plane that intersects the plane of the triangulation in a line, or
  /// null if it has none. With it, tests for the side of a constraint cost less.
  using PlaneThrough = std::function<const ExactPlane*(Index line)>;

  /// Starts with a large triangle around all points (scaffold). `plane` is a triangle in the plane.
  /// The box from `low` to `high` must contain all points that are inserted.
  PlanarTriangulation(const ExactGeometry& geometry, const Triangle& plane, const Vec3& low,
                      const Vec3& high, Crossing crossing, PlaneThrough plane_through = {});

  /// Inserts a triangle with its edges as constraints. Faster than insert() and constrain(), and
  /// only for planes in which a single triangle is cut. Must be called before any insertion. The
  /// corners become points 3, 4 and 5; the edges become lines 0, 1 and 2. Returns false and changes
  /// nothing if the scaffold around the triangle cannot be represented in doubles.
  bool begin_with_triangle(const std::array<ExactPoint, 3>& corners);
  /// Inserts a point; `lines` are known lines through this point. Returns its index, or the index
  /// of an equal point that was inserted before.
  Index insert(const ExactPoint& point, std::span<const Index> lines);
  Index insert(const ExactPoint& point, std::initializer_list<Index> lines) {
    return insert(point, std::span<const Index>(lines.begin(), lines.size()));
  }
  /// Records that further lines contain a point.
  void add_lines(Index point, std::span<const Index> lines) {
    for (const Index line : lines) add_line(point, line);
  }
  /// Inserts the segment between two points as a constraint, which becomes a chain of edges. Both
  /// points must be on line `line`.
  void constrain(Index from, Index to, Index line);
  /// Flips unconstrained edges until the triangulation is constrained Delaunay. If all four points
  /// are on a circle, the diagonal at the point whose definition has the least mesh vertices (in
  /// lexicographical order) is used. Hence the result depends neither on other insertions nor on
  /// the order of the faces. If `marked` is not empty, only edges of marked facets are flipped;
  /// constraints must separate marked from unmarked facets.
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
  /// Returns the edges (3 * facet + i) from one point to another along a constraint. `along` has
  /// the line of the constraint, and tells whether the edges have its direction.
  std::vector<Index> chain(Index from, Index to, OnEdge along) const;
  /// Selected facets with their points. The definition of a point is the set of mesh vertices,
  /// edges and faces that determine it. The facets are sorted by these definitions, so their order
  /// does not depend on the order of insertions.
  struct Collection {
    /// Points, in the order in which `facets` first refers to them.
    std::vector<ExactPoint> points;
    /// Corners of the facets, as indices in `points`. Each facet starts with the corner whose
    /// definition is least.
    std::vector<Face> facets;
    std::vector<Index> numbers;  ///< for each facet its index in PlanarTriangulation::facets()
  };
  Collection collect(const std::vector<char>& marked) const;

  const std::vector<Facet>& facets() const { return facets_; }
  const ExactPoint& point(Index i) const { return points_[i]; }
  std::size_t point_count() const { return points_.size(); }
  /// Returns the first point of an edge (3 * facet + i).
  Index source(Index edge) const { return facets_[edge / 3].v[edge % 3]; }
  /// Number of scaffold corners (corners of the large triangle around all points). They are the
  /// first points.
  static constexpr Index scaffold_points = 3;

 private:
  using Lines = boost::container::small_vector<Index, 4>;
  struct Segment {
    Index from, to, line;
    /// +1 if the front of the plane through the line is to the left of the segment, -1 if it is to
    /// the right, 0 if not known yet.
    mutable int front = 0;
  };
  struct Location {
    Index facet;
    /// Orientation of the located point relative to each edge of the facet: 0 if the point is on
    /// the edge. Two entries are 0 if the point is a corner.
    std::array<int, 3> side;
  };
  /// Node of a linked list of the constraints on an edge. The parts of a split edge share one list.
  /// Node `i` has the number 2 i if the edge has the direction of the constraint, and 2 i + 1 if it
  /// has the opposite direction.
  struct ListOnEdge {
    Index line;
    Index rest;    ///< number of the next node of the list, or no_index
    Index oldest;  ///< the first line that was inserted as a constraint on this edge
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
  PlaneThrough plane_through_;
  std::vector<ExactPoint> points_;
  std::vector<Lines> lines_;     ///< lines through each point, ascending
  std::vector<Index> facet_of_;  ///< for each point a facet of which it is a corner
  std::vector<Facet> facets_;
  std::vector<ListOnEdge> lists_;
};

}  // namespace transformesh
