#include "clean/arrange/planar_triangulation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "mesh/corners.h"

namespace transformesh {
namespace {

// Returns the corners of a large triangle around the box (the scaffold), at about 12 times the
// extent of the box. The corners are in the plane, up to rounding to doubles.
std::array<Vec3, 3> scaffold(const Triangle& plane, PlaneProjection p, const Vec3& low,
                             const Vec3& high) {
  const Vec3 middle = low + (high - low) / 2;
  const int w = 3 - p.u - p.v;
  const Vec3 normal = (plane[1] - plane[0]).cross(plane[2] - plane[0]);
  double size = std::max((high - low)[p.u], (high - low)[p.v]);
  if (!(size > 0)) size = 1;
  constexpr std::array<std::array<double, 2>, 3> directions{{{-10, -8}, {11, -7}, {-1, 12}}};
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3& corner = corners[i];
    corner[p.u] = middle[p.u] + size * directions[i][0];
    corner[p.v] = middle[p.v] + size * directions[i][1];
    const double slope =
        normal[p.u] * (corner[p.u] - plane[0][p.u]) + normal[p.v] * (corner[p.v] - plane[0][p.v]);
    corner[w] = plane[0][w] - slope / normal[w];
    if (!std::isfinite(corner[w])) corner[w] = middle[w];
  }
  return corners;
}

}  // namespace

PlanarTriangulation::PlanarTriangulation(const ExactGeometry& geometry, const Triangle& plane,
                                         const Vec3& low, const Vec3& high, Crossing crossing,
                                         PlaneThrough plane_through)
    : geometry_(geometry),
      projection_(projection_of(plane)),
      crossing_(std::move(crossing)),
      plane_through_(std::move(plane_through)) {
  for (const Vec3& corner : scaffold(plane, projection_, low, high)) {
    // NOLINTNEXTLINE(clang-analyzer-unix.Malloc): references are counted
    add_point(ExactGeometry::free(corner));
  }
  facets_.push_back({{0, 1, 2}, {no_index, no_index, no_index}, {no_index, no_index, no_index}});
  facet_of_.assign(3, 0);
}

bool PlanarTriangulation::begin_with_triangle(const std::array<ExactPoint, 3>& corners) {
  // The scaffold (a large triangle around all points) is the triangle, mirrored at its center and
  // enlarged. Hence one scaffold corner is opposite to each edge of the triangle.
  const Vec3 middle = corners[0].center / 3 + corners[1].center / 3 + corners[2].center / 3;
  const std::vector<ExactPoint> old_points = points_;
  // The corners of the scaffold are at this multiple of the distance of the triangle's corners from
  // its center. A choice: any value above 2 encloses the triangle, and larger values may overflow.
  constexpr double enlarged = 6;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& across = corners[(i + 2) % 3].center;
    // NOLINTNEXTLINE(clang-analyzer-unix.Malloc): references are counted
    points_[i] = ExactGeometry::free(middle + enlarged * (middle - across));
    if (!points_[i].center.allFinite()) return points_ = old_points, false;
  }
  points_.insert(points_.end(), corners.begin(), corners.end());
  lines_.resize(points_.size());
  constexpr std::array<Face, 7> facets{
      {{3, 4, 5}, {4, 3, 0}, {5, 4, 1}, {3, 5, 2}, {3, 2, 0}, {4, 0, 1}, {5, 1, 2}}};
  for (const Face& v : facets) {
    if (orientation(v[0], v[1], v[2]) > 0) continue;
    points_ = old_points;
    lines_.resize(points_.size());
    return false;
  }

  constexpr Index none = no_index;
  constexpr std::array<std::array<Index, 3>, 7> next{
      {{1, 2, 3}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {3, none, 1}, {1, none, 2}, {2, none, 3}}};
  facets_.clear();
  for (std::size_t i = 0; i < facets.size(); ++i)
    facets_.push_back({facets[i], next[i], {none, none, none}});
  facet_of_ = {4, 5, 6, 0, 0, 0};
  for (Index i = 0; i < 3; ++i) mark(i, i);
  return true;
}

// Returns the exact orientation of three points. If the floating-point filter does not decide, but
// a known line contains all three points, the result is 0 without exact arithmetic.
int PlanarTriangulation::orientation(Index a, Index b, Index c) const {
  const int sign = ExactGeometry::quick_orient2d(points_[a], points_[b], points_[c], projection_);
  if (sign != 0) return sign;
  if (share_line(lines_of(a), lines_of(b), lines_of(c))) return 0;
  return geometry_.orient2d(points_[a], points_[b], points_[c], projection_);
}

// Returns the side of a segment on which a point is: +1 for left, -1 for right, 0 for the line
// through the segment. Both ends of the segment must be on line `s.line`. A test against a plane
// through this line needs precise coordinates of one point, an orientation those of three. Corners
// of the scaffold are not exactly in the plane of the triangulation, so they have no such test.
int PlanarTriangulation::side_of(const Segment& s, Index point) const {
  const int sign =
      ExactGeometry::quick_orient2d(points_[s.from], points_[s.to], points_[point], projection_);
  if (sign != 0) return sign;
  if (std::binary_search(lines_[point].begin(), lines_[point].end(), s.line)) return 0;
  const bool has_plane = plane_through_ && point >= scaffold_points;
  const ExactPlane* plane = has_plane ? plane_through_(s.line) : nullptr;
  if (plane == nullptr) return orientation(s.from, s.to, point);
  const int side = geometry_.orient3d(*plane, points_[point]);
  if (s.front == 0) s.front = side * orientation(s.from, s.to, point);
  return s.front * side;
}

bool PlanarTriangulation::share_line(std::span<const Index> a, std::span<const Index> b,
                                     std::span<const Index> c) {
  std::span<const Index> shortest = c;
  if (a.size() < shortest.size()) shortest = a;
  if (b.size() < shortest.size()) shortest = b;
  const auto is_in = [](std::span<const Index> lines, Index line) {
    return std::binary_search(lines.begin(), lines.end(), line);
  };
  return std::any_of(shortest.begin(), shortest.end(), [&](Index line) {
    return is_in(a, line) && is_in(b, line) && is_in(c, line);
  });
}

// True if `through` is on the same side of `from` as `to`. The three points must be collinear.
bool PlanarTriangulation::is_ahead(Index from, Index through, Index to) const {
  for (const int coordinate : {projection_.u, projection_.v}) {
    const int sign = geometry_.compare_coordinate(points_[to], points_[from], coordinate);
    if (sign == 0) continue;
    return sign == geometry_.compare_coordinate(points_[through], points_[from], coordinate);
  }
  return false;
}

Index PlanarTriangulation::add_point(const ExactPoint& point) {
  points_.push_back(point);
  lines_.emplace_back();
  facet_of_.push_back(no_index);
  return static_cast<Index>(points_.size() - 1);
}

void PlanarTriangulation::add_line(Index point, Index line) {
  Lines& lines = lines_[point];
  const auto at = std::lower_bound(lines.begin(), lines.end(), line);
  if (at == lines.end() || *at != line) lines.insert(at, line);
}

// Finds the facet that contains a point, by moving from facet to facet towards the point. If the
// triangulation is not Delaunay, this may return to an earlier facet again and again. Therefore all
// n facets are tested one by one after 3 n + 10 steps.
PlanarTriangulation::Location PlanarTriangulation::locate(const ExactPoint& point,
                                                          std::span<const Index> lines) const {
  const auto side_of = [&](Index a, Index b) {
    const int sign = ExactGeometry::quick_orient2d(points_[a], points_[b], point, projection_);
    if (sign != 0) return sign;
    if (share_line(lines_of(a), lines_of(b), lines)) return 0;
    return geometry_.orient2d(points_[a], points_[b], point, projection_);
  };
  Location location{facet_of_.back(), {}};
  Index entry = no_index;  // the edge of the facet that was crossed: the point is to its left
  const auto leave_by = [&](Index first) {
    Index exit = no_index;
    for (Index k = 0; k < 3; ++k) {
      const Index i = (first + k) % 3;
      const Facet& facet = facets_[location.facet];
      const bool is_entry = 3 * location.facet + i == entry;
      location.side[i] = is_entry ? 1 : side_of(facet.v[i], facet.v[next_corner(i)]);
      if (location.side[i] < 0) {
        exit = i;
        break;
      }
    }
    return exit;
  };
  for (std::size_t step = 0; step < 3 * facets_.size() + 10; ++step) {
    const Index exit = leave_by(static_cast<Index>(step % 3));
    if (exit == no_index) return location;
    entry = opposite(3 * location.facet + exit);
    if (entry == no_index) break;
    location.facet = entry / 3;
  }
  entry = no_index;
  for (location.facet = 0; location.facet < facets_.size(); ++location.facet) {
    if (leave_by(0) == no_index) return location;
  }
  throw std::logic_error("a point lies outside its plane's scaffold");
}

Index PlanarTriangulation::insert(const ExactPoint& point, std::span<const Index> lines) {
  const Location location = locate(point, lines);
  const Facet facet = facets_[location.facet];
  const auto zeros = std::count(location.side.begin(), location.side.end(), 0);
  Index index = no_index;
  for (Index i = 0; i < 3 && zeros == 2; ++i) {
    if (location.side[i] == 0 && location.side[previous_corner(i)] == 0) index = facet.v[i];
  }
  if (index == no_index) {
    index = add_point(point);
    if (zeros == 0) split_facet(location.facet, index);
    for (Index i = 0; i < 3 && zeros == 1; ++i) {
      if (location.side[i] == 0) split_edge(3 * location.facet + i, index);
    }
    legalize(index);
  } else if (point.definition.kind == ExactPoint::Kind::given) {
    // An equal point exists. Replace its definition by the mesh vertex, because a vertex has the
    // same definition in all planes.
    points_[index] = point;
  }
  for (const Index line : lines) add_line(index, line);
  return index;
}

// Writes the data of a facet. Also updates `next` of the neighbors of the facet and `facet_of_` of
// its corners.
void PlanarTriangulation::set_facet(Index facet, const std::array<Index, 3>& v,
                                    const std::array<Index, 3>& next,
                                    const std::array<Index, 3>& line) {
  facets_[facet] = {v, next, line};
  for (Index i = 0; i < 3; ++i) {
    facet_of_[v[i]] = facet;
    if (next[i] == no_index) continue;
    Facet& neighbor = facets_[next[i]];
    for (Index k = 0; k < 3; ++k) {
      if (neighbor.v[k] == v[next_corner(i)] && neighbor.v[next_corner(k)] == v[i]) {
        neighbor.next[k] = facet;
      }
    }
  }
}

void PlanarTriangulation::split_facet(Index facet, Index p) {
  const Facet old = facets_[facet];
  const auto second = static_cast<Index>(facets_.size());
  const Index third = second + 1;
  facets_.resize(facets_.size() + 2, old);
  const Index none = no_index;
  set_facet(facet, {old.v[0], old.v[1], p}, {old.next[0], second, third},
            {old.line[0], none, none});
  set_facet(second, {old.v[1], old.v[2], p}, {old.next[1], third, facet},
            {old.line[1], none, none});
  set_facet(third, {old.v[2], old.v[0], p}, {old.next[2], facet, second},
            {old.line[2], none, none});
}

// Splits both facets at an edge. The edge must not be an edge of the scaffold.
void PlanarTriangulation::split_edge(Index edge, Index p) {
  const Index f = edge / 3, i = edge % 3;
  const Index back = opposite(edge);
  const Index g = back / 3, k = back % 3;
  const Facet left = facets_[f], right = facets_[g];
  const Index a = left.v[i], b = left.v[next_corner(i)];
  const Index c = left.v[previous_corner(i)], d = right.v[previous_corner(k)];
  const Index line = left.line[i], line_back = right.line[k];
  const auto f2 = static_cast<Index>(facets_.size());
  const Index g2 = f2 + 1;
  facets_.resize(facets_.size() + 2, left);
  const Index none = no_index;
  // The left facet a b c becomes a p c and p b c; the right facet b a d becomes p a d and b p d.
  facets_[f] = {{a, p, c},
                {g, f2, left.next[previous_corner(i)]},
                {line, none, left.line[previous_corner(i)]}};
  facets_[g] = {{p, a, d},
                {f, right.next[next_corner(k)], g2},
                {line_back, right.line[next_corner(k)], none}};
  set_facet(f2, {p, b, c}, {g2, left.next[next_corner(i)], f},
            {line, left.line[next_corner(i)], none});
  set_facet(g2, {b, p, d}, {f2, g, right.next[previous_corner(k)]},
            {line_back, none, right.line[previous_corner(k)]});
  set_facet(f, facets_[f].v, facets_[f].next, facets_[f].line);
  set_facet(g, facets_[g].v, facets_[g].next, facets_[g].line);
  // A line through both ends of the edge also contains the new point.
  const Lines of_a = lines_[a];
  std::set_intersection(of_a.begin(), of_a.end(), lines_[b].begin(), lines_[b].end(),
                        std::back_inserter(lines_[p]));
}

Index PlanarTriangulation::opposite(Index edge) const {
  const Facet& facet = facets_[edge / 3];
  const Index neighbor = facet.next[edge % 3];
  if (neighbor == no_index) return no_index;
  const Index from = facet.v[next_corner(edge % 3)];
  for (Index k = 0; k < 3; ++k) {
    if (facets_[neighbor].v[k] == from) return 3 * neighbor + k;
  }
  return no_index;
}

Index PlanarTriangulation::target(Index edge) const {
  return facets_[edge / 3].v[next_corner(edge % 3)];
}

// Visits the edges that start at the point, in order around the point. Returns the first edge for
// which `accept` returns true, or no_index. The point must not be a corner of the scaffold.
template <class Accept>
Index PlanarTriangulation::find_edge_from(Index point, const Accept& accept) const {
  const Index start = facet_of_[point];
  Index facet = start;
  do {
    Index i = 0;
    while (facets_[facet].v[i] != point) ++i;
    if (accept(3 * facet + i)) return 3 * facet + i;
    facet = facets_[facet].next[previous_corner(i)];
  } while (facet != start);
  return no_index;
}

// Replaces the edge by the other diagonal of its two facets; returns the new diagonal.
Index PlanarTriangulation::flip(Index edge) {
  const Index back = opposite(edge);
  const Index f = edge / 3, i = edge % 3, g = back / 3, k = back % 3;
  const Facet left = facets_[f], right = facets_[g];
  const Index a = left.v[i], b = left.v[next_corner(i)];
  const Index c = left.v[previous_corner(i)], d = right.v[previous_corner(k)];
  const Index none = no_index;
  const std::array<Index, 3> f_next{right.next[next_corner(k)], g, left.next[previous_corner(i)]};
  const std::array<Index, 3> g_next{left.next[next_corner(i)], f, right.next[previous_corner(k)]};
  // The facets a b c and b a d become a d c and b c d.
  facets_[f].v = {a, d, c};
  facets_[g].v = {b, c, d};
  set_facet(f, {a, d, c}, f_next,
            {right.line[next_corner(k)], none, left.line[previous_corner(i)]});
  set_facet(g, {b, c, d}, g_next,
            {left.line[next_corner(i)], none, right.line[previous_corner(k)]});
  return 3 * f + 1;
}

bool PlanarTriangulation::is_convex(Index edge) const {
  const Index back = opposite(edge);
  const Index a = facets_[edge / 3].v[edge % 3];
  const Index b = facets_[back / 3].v[back % 3];
  const Index c = facets_[edge / 3].v[previous_corner(edge % 3)];
  const Index d = facets_[back / 3].v[previous_corner(back % 3)];
  return orientation(a, d, c) > 0 && orientation(b, c, d) > 0;
}

// True if the edge is unconstrained, and the other diagonal of its two facets is better by the
// Delaunay criterion. If `breaks_ties` is set, an exact test decides if the floating-point test
// does not. If both diagonals are equally good, the one at the point whose definition has the least
// mesh vertices (in lexicographical order) is better.
bool PlanarTriangulation::wants_flip(Index edge, bool breaks_ties) const {
  const Facet& facet = facets_[edge / 3];
  if (facet.line[edge % 3] != no_index || facet.next[edge % 3] == no_index) return false;
  const Index back = opposite(edge);
  const Index a = facet.v[edge % 3], b = facets_[back / 3].v[back % 3];
  const Index c = facet.v[previous_corner(edge % 3)];
  const Index d = facets_[back / 3].v[previous_corner(back % 3)];
  const auto &pa = points_[a], &pb = points_[b], &pc = points_[c], &pd = points_[d];
  int sign = breaks_ties ? geometry_.delaunay_sign(pa, pb, pc, pd, projection_)
                         : ExactGeometry::quick_delaunay_sign(pa, pb, pc, pd, projection_);
  if (sign == 0 && breaks_ties) {
    const auto key = [&](Index p) { return geometry_.vertices_of(points_[p].definition); };
    if (std::min(key(c), key(d)) < std::min(key(a), key(b))) sign = -1;
  }
  if (sign >= 0) return false;
  return is_convex(edge);
}

// Flips edges opposite to a new point until the facets at this point are Delaunay. The
// floating-point test may undo its own flips because of rounding errors; therefore the number of
// flips is limited.
void PlanarTriangulation::legalize(Index p) {
  std::vector<Index> stack;
  const auto push_star = [&](Index facet) {
    for (Index i = 0; i < 3; ++i) {
      if (facets_[facet].v[i] == p) stack.push_back(3 * facet + next_corner(i));
    }
  };
  const Index start = facet_of_[p];
  Index facet = start;
  do {
    push_star(facet);
    Index i = 0;
    while (facets_[facet].v[i] != p) ++i;
    facet = facets_[facet].next[i];
  } while (facet != start);
  for (std::size_t budget = 64 + 4 * facets_.size(); !stack.empty() && budget > 0; --budget) {
    const Index edge = stack.back();
    stack.pop_back();
    const Facet& f = facets_[edge / 3];
    if (f.v[previous_corner(edge % 3)] != p || !wants_flip(edge, false)) continue;
    const Index diagonal = flip(edge);
    push_star(diagonal / 3);
    push_star(facets_[diagonal / 3].next[diagonal % 3]);
  }
}

void PlanarTriangulation::improve(const std::vector<char>& marked) {
  // Each edge is tested from one of its two facets. A flip adds all edges whose numbers it changes.
  std::vector<Index> stack;
  for (auto edge = static_cast<Index>(3 * facets_.size()); edge-- > 0;)
    if ((marked.empty() || marked[edge / 3]) && edge < opposite(edge)) stack.push_back(edge);
  for (std::size_t budget = 100 + 30 * facets_.size(); !stack.empty() && budget > 0; --budget) {
    const Index edge = stack.back();
    stack.pop_back();
    if (!wants_flip(edge, true)) continue;
    const Index diagonal = flip(edge);
    const Index other = opposite(diagonal);
    for (const Index e : {diagonal, other}) {
      stack.push_back(next_edge(e));
      stack.push_back(previous_edge(e));
    }
  }
}

// Returns the edge between two points, or no_index.
Index PlanarTriangulation::edge_between(Index from, Index to) const {
  if (from < scaffold_points) return opposite(edge_between(to, from));
  return find_edge_from(from, [&](Index edge) { return target(edge) == to; });
}

void PlanarTriangulation::mark(Index edge, Index line) {
  const Index back = opposite(edge);
  Index& list = facets_[edge / 3].line[edge % 3];
  const auto number = static_cast<Index>(2 * lists_.size());
  lists_.push_back({line, list, list == no_index ? line : lists_[list / 2].oldest});
  list = number;
  facets_[back / 3].line[back % 3] = number + 1;
  add_line(facets_[edge / 3].v[edge % 3], line);
  add_line(facets_[back / 3].v[back % 3], line);
}

void PlanarTriangulation::constrain(Index from, Index to, Index line) {
  for (Segment s{from, to, line}; s.from != to;) s.from = step_along(s);
}

// Makes the part of the segment from its start to the next point on it a constrained edge. Returns
// this next point.
Index PlanarTriangulation::step_along(const Segment& s) {
  bool is_along = false;
  Index known = no_index;  // the latest tested point, and its side
  int known_side = 0;
  const auto side_at = [&](Index point) {
    if (point != known) known_side = point == s.to ? 0 : side_of(s, point);
    known = point;
    return known_side;
  };
  const Index edge = find_edge_from(s.from, [&](Index e) {
    const Index x = target(e), y = target(next_edge(e));
    const int side_of_x = side_at(x);
    is_along = side_of_x == 0 && (x == s.to || is_ahead(s.from, x, s.to));
    return is_along || (side_of_x < 0 && side_at(y) > 0);
  });
  if (edge == no_index) throw std::logic_error("a constraint leaves its plane's scaffold");
  if (!is_along) return march(next_edge(edge), s);
  mark(edge, s.line);
  return target(edge);
}

// Follows the segment from its start across `edge` to the next point on the segment, and makes this
// part an edge. If the segment crosses a constrained edge first, that edge is split at the
// intersection, which is then the next point. Returns the next point.
Index PlanarTriangulation::march(Index edge, const Segment& s) {
  std::vector<std::array<Index, 2>> crossed;
  Index end = no_index;
  while (end == no_index) {
    const Facet& facet = facets_[edge / 3];
    const Index others = facet.line[edge % 3];
    if (others != no_index) {
      end = add_point(crossing_(s.line, lists_[others / 2].oldest));
      add_line(end, s.line);
      split_edge(edge, end);
      break;
    }
    crossed.push_back({facet.v[edge % 3], facet.v[next_corner(edge % 3)]});
    const Index back = opposite(edge);
    const Index apex = facets_[back / 3].v[previous_corner(back % 3)];
    const int side = apex == s.to ? 0 : side_of(s, apex);
    if (side == 0) end = apex;
    // If the apex is to the left of the segment, the segment leaves the facet through the edge to
    // the right of the apex. Otherwise it leaves through the edge to the left.
    edge = side > 0 ? next_edge(back) : previous_edge(back);
  }
  clear_way(std::move(crossed), {s.from, end, s.line});
  mark(edge_between(s.from, end), s.line);
  return end;
}

// Flips the edges in `crossed` until no edge crosses the segment; then the segment is an edge
// (Sloan 1993). An edge whose two facets form a non-convex quadrilateral cannot be flipped, and is
// appended to the queue again.
void PlanarTriangulation::clear_way(std::vector<std::array<Index, 2>> crossed, const Segment& s) {
  std::deque<std::array<Index, 2>> queue(crossed.begin(), crossed.end());
  while (!queue.empty()) {
    const auto [x, y] = queue.front();
    queue.pop_front();
    const Index edge = edge_between(x, y);
    const Index c = source(previous_edge(edge)), d = source(previous_edge(opposite(edge)));
    // If the facets lie between the ends of the segment, they are convex: it crosses their edge.
    const bool is_last = (c == s.from && d == s.to) || (c == s.to && d == s.from);
    if (!is_last && !is_convex(edge)) {
      queue.push_back({x, y});
      continue;
    }
    const Index diagonal = flip(edge);
    const Index p = facets_[diagonal / 3].v[diagonal % 3];
    const Index q = facets_[diagonal / 3].v[next_corner(diagonal % 3)];
    if (p == s.from || p == s.to || q == s.from || q == s.to) continue;
    if (side_of(s, p) * side_of(s, q) < 0) queue.push_back({p, q});
  }
}

std::vector<Index> PlanarTriangulation::chain(Index from, Index to, OnEdge along) const {
  std::vector<Index> edges;
  while (from != to) {
    const Index edge = find_edge_from(from, [&](Index e) {
      bool is_found = false;
      for_each_line(e / 3, e % 3, [&](const OnEdge& on) { is_found |= on == along; });
      return is_found;
    });
    if (edge == no_index) throw std::logic_error("a constraint is missing from its plane");
    edges.push_back(edge);
    from = target(edge);
  }
  return edges;
}

PlanarTriangulation::Collection PlanarTriangulation::collect(
    const std::vector<char>& marked) const {
  Collection result;
  for (Index facet = 0; facet < marked.size(); ++facet) {
    if (!marked[facet]) continue;
    Face v = facets_[facet].v;
    const auto is_less = [&](Index a, Index b) { return is_before(a, b); };
    std::rotate(v.begin(), std::min_element(v.begin(), v.end(), is_less), v.end());
    result.facets.push_back(v);
    result.numbers.push_back(facet);
  }
  std::vector<Index> order(result.facets.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::lexicographical_compare(result.facets[a].begin(), result.facets[a].end(),
                                        result.facets[b].begin(), result.facets[b].end(),
                                        [&](Index p, Index q) { return is_before(p, q); });
  });

  Collection sorted;
  std::vector<Index> number(points_.size(), no_index);
  for (const Index i : order) {
    Face v = result.facets[i];
    for (Index& corner : v) {
      if (number[corner] == no_index) {
        number[corner] = static_cast<Index>(sorted.points.size());
        sorted.points.push_back(points_[corner]);
        // Exact coordinates take most of the memory of a point, and few points need them again.
        if (points_[corner].definition.is_known()) sorted.points.back().exact = nullptr;
      }
      corner = number[corner];
    }
    sorted.facets.push_back(v);
    sorted.numbers.push_back(result.numbers[i]);
  }
  return sorted;
}

}  // namespace transformesh
