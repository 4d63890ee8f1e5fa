#include "geometry/numbers/exact_point.h"

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "geometry/numbers/double_double_ball.h"
#include "geometry/numbers/exact_number.h"
#include "geometry/numbers/homogeneous.h"
#include "geometry/numbers/multiprecision_ball.h"
#include "geometry/numbers/number_vector.h"
#include "geometry/numbers/wide_exponent_ball.h"

namespace transformesh {

/// Exact coordinates; the weight is positive.
struct ExactCoordinates : HomogeneousPoint<ExactNumber> {};

/// Coordinates with twice the precision of a double, if these can be computed. If magnitudes in the
/// definition differ strongly, numbers become long and digits are lost. Then balls of homogeneous
/// coordinates with positive weight are more precise; each kind is computed on demand.
struct PreciseCoordinates {
  NumberVector<DoubleDoubleBall> x;
  bool is_spread = false;
  std::shared_ptr<const HomogeneousPoint<WideExponentBall>> wide;
  std::shared_ptr<const HomogeneousPoint<MultiprecisionBall>> longer;
};

struct PreciseNormal {
  NumberVector<DoubleDoubleBall> normal;
};
struct ExactPlaneCoordinates : HomogeneousPlane<ExactNumber> {};

namespace {

using Exact = ExactNumber;
using Interval = CGAL::Interval_nt<false>;
template <class Number>
using Vector = NumberVector<Number>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double underflow_guard = 1e-280;  ///< exceeds the error of products by underflow

/// A point as origin + numerator / denominator; the origin is a mesh vertex.
template <class Number>
struct Fraction {
  Vec3 origin;
  Vector<Number> numerator;
  Number denominator;
};

template <class Number>
Fraction<Number> along_edge(const Vec3& u, const Vec3& v, const Number& from_u,
                            const Number& total) {
  Vector<Number> step = difference<Number>(v, u);
  for (Number& coordinate : step) coordinate = coordinate * from_u;
  return {u, step, total};
}

// The heights of u and v above the plane divide the edge.
template <class Number>
Fraction<Number> line_plane_fraction(const Vec3& u, const Vec3& v, const Triangle& plane) {
  const Vector<Number> n = normal<Number>(plane);
  const Number height_u = dot(n, difference<Number>(plane[0], u));
  const Number climb = dot(n, difference<Number>(v, u));
  return along_edge(u, v, height_u, climb);
}

// The parameter in the projection is ((x - u) x (y - x)) / ((v - u) x (y - x)).
template <class Number>
Fraction<Number> line_line_fraction(const Vec3& u, const Vec3& v, const Vec3& x, const Vec3& y,
                                    PlaneProjection p) {
  const auto turn = [&](const Vector<Number>& a, const Vector<Number>& b) {
    const auto i = static_cast<std::size_t>(p.u);
    const auto j = static_cast<std::size_t>(p.v);
    return Number(a[i] * b[j] - a[j] * b[i]);
  };
  const Vector<Number> other = difference<Number>(y, x);
  return along_edge(u, v, turn(difference<Number>(x, u), other),
                    turn(difference<Number>(v, u), other));
}

// Applies Cramer's rule relative to a corner of the first plane, so that its offset is zero.
template <class Number>
Fraction<Number> three_planes_fraction(const Triangle& f, const Triangle& g, const Triangle& h) {
  const Vector<Number> nf = normal<Number>(f);
  const Vector<Number> ng = normal<Number>(g);
  const Vector<Number> nh = normal<Number>(h);
  const Number dg = dot(ng, difference<Number>(g[0], f[0]));
  const Number dh = dot(nh, difference<Number>(h[0], f[0]));
  const Vector<Number> hf = cross(nh, nf);
  const Vector<Number> fg = cross(nf, ng);
  Vector<Number> numerator;
  for (std::size_t i = 0; i < 3; ++i) numerator[i] = dg * hf[i] + dh * fg[i];
  return {f[0], numerator, dot(ng, hf)};
}

ExactCoordinates exact_coordinates(const Fraction<Exact>& fraction) {
  const bool negative = sign_of(fraction.denominator) < 0;
  ExactCoordinates result;
  result.w = negative ? -fraction.denominator : fraction.denominator;
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact numerator = negative ? -fraction.numerator[i] : fraction.numerator[i];
    result.x[i] = Exact(fraction.origin[static_cast<int>(i)]) * result.w + numerator;
  }
  return result;
}

// Sets the ball to the center of an interval, with a radius that includes the rounding errors.
void set_ball(ExactPoint& point, int i, double low, double high) {
  if (!(std::isfinite(low) && std::isfinite(high) && low <= high)) {
    point.center[i] = 0;
    point.radius[i] = std::numeric_limits<double>::infinity();
    return;
  }
  const double center = low + (high - low) / 2;
  const double radius = std::max(high - center, center - low);
  point.center[i] = center;
  point.radius[i] = radius == 0 ? 0 : radius * (1 + 4 * epsilon) + 1e-300;
}

bool has_sign(const Interval& number) { return !number.do_overlap(Interval(0)); }
bool has_sign(const WideExponentBall& number) { return number.sign() != 0; }
std::array<double, 2> ends_of(const Interval& number) { return {number.inf(), number.sup()}; }
std::array<double, 2> ends_of(const WideExponentBall& number) {
  return {number.low(), number.high()};
}

// Sets the ball from a fraction, and restricts it to the box that is known to contain the point.
// Returns true if the fraction gives finite bounds.
template <class Number>
bool set_balls(ExactPoint& point, const Fraction<Number>& fraction, const Vec3& low,
               const Vec3& high) {
  const bool is_certain = has_sign(fraction.denominator);
  bool is_finite = is_certain;
  for (int i = 0; i < 3; ++i) {
    double from = low[i];
    double to = high[i];
    if (is_certain) {
      const auto [least, most] =
          ends_of(Number(fraction.origin[i]) +
                  fraction.numerator[static_cast<std::size_t>(i)] / fraction.denominator);
      is_finite = is_finite && std::isfinite(least) && std::isfinite(most);
      from = std::max(from, least);
      to = std::min(to, most);
    }
    set_ball(point, i, from, to);
  }
  return is_finite;
}

// Products of seven differences of smaller coordinates do not overflow.
constexpr double large = 0x1p140;

// Sets the ball by interval arithmetic, or by wide balls if intervals may overflow, because
// overflow depends on the processor. `fraction_in` computes the fraction in the number type of its
// argument. `size` is the largest absolute value of the coordinates.
template <class FractionIn>
void set_balls(ExactPoint& point, const FractionIn& fraction_in, double size, const Vec3& low,
               const Vec3& high) {
  const CGAL::Protect_FPU_rounding<true> upward;
  if (size < large && set_balls(point, fraction_in(Interval(0)), low, high)) return;
  set_balls(point, fraction_in(WideExponentBall(0)), low, high);
}

double size_of(std::initializer_list<Vec3> points) {
  double size = 0;
  for (const Vec3& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
  return size;
}
double size_of(const Triangle& t) { return size_of({t[0], t[1], t[2]}); }

BoundedNumber bounded(const ExactPoint& point, int i) { return {point.center[i], point.radius[i]}; }

Vector<BoundedNumber> bounded(const ExactPoint& point) {
  return {bounded(point, 0), bounded(point, 1), bounded(point, 2)};
}

Vector<WideExponentBall> wide_difference(const ExactPoint& a, const ExactPoint& b) {
  const auto minus = [&](int i) {
    return WideExponentBall(a.center[i], a.radius[i]) - WideExponentBall(b.center[i], b.radius[i]);
  };
  return {minus(0), minus(1), minus(2)};
}

int wide_orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                  PlaneProjection p) {
  const Vector<WideExponentBall> ab = wide_difference(b, a), ac = wide_difference(c, a);
  const auto u = static_cast<std::size_t>(p.u), v = static_cast<std::size_t>(p.v);
  return (ab[u] * ac[v] - ab[v] * ac[u]).sign();
}

bool is_exact(const ExactPoint& point) { return point.radius == Vec3::Zero(); }

}  // namespace

Triangle ExactGeometry::triangle(Index face) const { return triangle_of(positions_, faces_[face]); }

ExactPoint ExactGeometry::point(const PointDefinition& definition) const {
  switch (definition.kind) {
    case ExactPoint::Kind::given: {
      ExactPoint point = free(positions_[definition.indices[0]]);
      point.definition = definition;
      return point;
    }
    case ExactPoint::Kind::line_plane:
      return line_plane(definition);
    case ExactPoint::Kind::line_line:
      return line_line(definition);
    default:
      throw std::logic_error("a definition does not make a point");
  }
}

ExactPoint ExactGeometry::free(const Vec3& position) {
  ExactPoint point;
  point.center = position;
  return point;
}

ExactPoint ExactGeometry::line_plane(const PointDefinition& definition) const {
  const auto [u, v, face, none] = definition.indices;
  const Vec3 &a = positions_[u], &b = positions_[v];
  const Triangle plane = triangle(face);
  ExactPoint point;
  point.definition = definition;
  const auto fraction = [&]<class Number>(const Number&) {
    return line_plane_fraction<Number>(a, b, plane);
  };
  set_balls(point, fraction, std::max(size_of({a, b}), size_of(plane)), a.cwiseMin(b),
            a.cwiseMax(b));
  return point;
}

namespace {

// Returns a projection in which the edges are not parallel. Two edges that intersect in one point
// span a plane, and any such projection is valid.
PlaneProjection projection_of_edges(const Vec3& u, const Vec3& v, const Vec3& x, const Vec3& y) {
  PlaneProjection projection = projection_of({u, v, x});
  if (orient2d(u, v, x, projection) == 0) projection = projection_of({u, v, y});
  return projection;
}

}  // namespace

ExactPoint ExactGeometry::line_line(const PointDefinition& definition) const {
  const auto& ends = definition.indices;
  const Vec3 &a = positions_[ends[0]], &b = positions_[ends[1]];
  const Vec3 &c = positions_[ends[2]], &d = positions_[ends[3]];
  ExactPoint point;
  point.definition = definition;
  const PlaneProjection projection = projection_of_edges(a, b, c, d);
  const auto fraction = [&]<class Number>(const Number&) {
    return line_line_fraction<Number>(a, b, c, d, projection);
  };
  set_balls(point, fraction, size_of({a, b, c, d}), a.cwiseMin(b).cwiseMax(c.cwiseMin(d)),
            a.cwiseMax(b).cwiseMin(c.cwiseMax(d)));
  return point;
}

ExactPoint ExactGeometry::three_planes(Index f, Index g, Index h) const {
  ExactPoint point;
  point.definition = PointDefinition::three_planes(f, g, h);
  const auto& ids = point.definition.indices;
  std::array<Triangle, 3> planes{triangle(ids[0]), triangle(ids[1]), triangle(ids[2])};
  Vec3 low = Vec3::Constant(-std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const Triangle& t : {triangle(g), triangle(h)}) {
    low = low.cwiseMax(t[0].cwiseMin(t[1]).cwiseMin(t[2]));
    high = high.cwiseMin(t[0].cwiseMax(t[1]).cwiseMax(t[2]));
  }
  const auto fraction = [&]<class Number>(const Number&) {
    return three_planes_fraction<Number>(planes[0], planes[1], planes[2]);
  };
  const double size = std::max({size_of(planes[0]), size_of(planes[1]), size_of(planes[2])});
  set_balls(point, fraction, size, low, high);
  return point;
}

namespace {

template <class Number>
Fraction<Number> fraction_of(const PointDefinition& definition, std::span<const Vec3> positions,
                             std::span<const Face> faces) {
  const auto& d = definition.indices;
  const auto plane = [&](int i) { return triangle_of(positions, faces[d[i]]); };
  switch (definition.kind) {
    case ExactPoint::Kind::line_plane:
      return line_plane_fraction<Number>(positions[d[0]], positions[d[1]], plane(2));
    case ExactPoint::Kind::line_line: {
      const Vec3 &a = positions[d[0]], &b = positions[d[1]];
      const Vec3 &x = positions[d[2]], &y = positions[d[3]];
      return line_line_fraction<Number>(a, b, x, y, projection_of_edges(a, b, x, y));
    }
    case ExactPoint::Kind::three_planes:
      return three_planes_fraction<Number>(plane(0), plane(1), plane(2));
    default:
      throw std::logic_error("this point carries its coordinates from the start");
  }
}

Vector<DoubleDoubleBall> precise_coordinates(const Fraction<DoubleDoubleBall>& fraction) {
  Vector<DoubleDoubleBall> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = fraction.denominator.sign() == 0
                    ? DoubleDoubleBall::unknown()
                    : DoubleDoubleBall(fraction.origin[static_cast<int>(i)]) +
                          fraction.numerator[i] / fraction.denominator;
  }
  return result;
}

template <class Ball>
HomogeneousPoint<Ball> with_positive_weight(HomogeneousPoint<Ball> point) {
  const int sign = point.w.sign();
  if (sign == 0) point.w = Ball::unknown();
  if (sign >= 0) return point;
  for (Ball& x : point.x) x = -x;
  point.w = -point.w;
  return point;
}

template <class Ball>
HomogeneousPoint<Ball> homogeneous_balls(const PointDefinition& definition,
                                         std::span<const Vec3> positions,
                                         std::span<const Face> faces) {
  const auto& d = definition.indices;
  const auto plane = [&](int i) {
    return homogeneous_plane<Ball>(triangle_of(positions, faces[d[i]]));
  };
  switch (definition.kind) {
    case ExactPoint::Kind::line_plane:
      return with_positive_weight(homogeneous_point(positions[d[0]], positions[d[1]], plane(2)));
    case ExactPoint::Kind::three_planes:
      return with_positive_weight(homogeneous_point(plane(0), plane(1), plane(2)));
    default:
      return {{Ball::unknown(), Ball::unknown(), Ball::unknown()}, Ball::unknown()};
  }
}

template <class Visit>
void visit_vertices(const PointDefinition& definition, std::span<const Face> faces,
                    const Visit& visit) {
  const auto& d = definition.indices;
  const auto visit_face = [&](Index face) {
    for (const Index vertex : faces[face]) visit(vertex);
  };
  switch (definition.kind) {
    case ExactPoint::Kind::line_plane:
      visit(d[0]);
      visit(d[1]);
      return visit_face(d[2]);
    case ExactPoint::Kind::line_line:
      for (const Index vertex : d) visit(vertex);
      return;
    case ExactPoint::Kind::three_planes:
      for (std::size_t i = 0; i < 3; ++i) visit_face(d[i]);
      return;
    default:
      return;
  }
}

// True if the magnitudes of coordinates differ so strongly that numbers become long.
bool is_spread(const PointDefinition& definition, std::span<const Vec3> positions,
               std::span<const Face> faces) {
  // Ratio of magnitudes above which balls are tried before exact numbers. A choice that affects
  // time only.
  constexpr double most_spread = 0x1p128;
  double least = std::numeric_limits<double>::max(), most = 0;
  visit_vertices(definition, faces, [&](Index vertex) {
    for (const double x : positions[vertex]) {
      least = x == 0 ? least : std::min(least, std::abs(x));
      most = std::max(most, std::abs(x));
    }
  });
  return most / most_spread > least;
}

}  // namespace

const ExactCoordinates& ExactGeometry::exact(const ExactPoint& point) const {
  if (point.exact) return *point.exact;
  const Vec3& p = point.center;
  ExactCoordinates coordinates =
      is_exact(point) ? ExactCoordinates{{{Exact(p[0]), Exact(p[1]), Exact(p[2])}, Exact(1)}}
                      : exact_coordinates(fraction_of<Exact>(point.definition, positions_, faces_));
  point.exact = std::make_shared<const ExactCoordinates>(std::move(coordinates));
  return *point.exact;
}

const PreciseCoordinates& ExactGeometry::precise(const ExactPoint& point) const {
  if (point.precise) return *point.precise;
  const Vec3& p = point.center;
  PreciseCoordinates coordinates;
  if (is_exact(point)) {
    coordinates.x = {DoubleDoubleBall(p[0]), DoubleDoubleBall(p[1]), DoubleDoubleBall(p[2])};
  } else if (!point.definition.is_known()) {
    coordinates.x.fill(DoubleDoubleBall::unknown());
  } else {
    coordinates.x =
        precise_coordinates(fraction_of<DoubleDoubleBall>(point.definition, positions_, faces_));
    for (int i = 0; i < 3; ++i)
      if (point.radius[i] == 0) coordinates.x[static_cast<std::size_t>(i)] = DoubleDoubleBall(p[i]);
    coordinates.is_spread = is_spread(point.definition, positions_, faces_);
  }
  point.precise = std::make_shared<const PreciseCoordinates>(std::move(coordinates));
  return *point.precise;
}

template <class Ball, class Coordinates>
auto& balls_of(Coordinates& known) {
  if constexpr (std::is_same_v<Ball, WideExponentBall>)
    return known.wide;
  else
    return known.longer;
}

// Replaces the shared cache of the point instead of changing it, because other threads may read
// copies.
template <class Ball>
const HomogeneousPoint<Ball>& ExactGeometry::spread(const ExactPoint& point) const {
  if (const auto& balls = balls_of<Ball>(precise(point))) return *balls;
  PreciseCoordinates known = *point.precise;
  auto& balls = balls_of<Ball>(known);
  balls = std::make_shared<const HomogeneousPoint<Ball>>(
      is_exact(point) ? HomogeneousPoint<Ball>{number_vector<Ball>(point.center), Ball(1)}
                      : homogeneous_balls<Ball>(point.definition, positions_, faces_));
  const HomogeneousPoint<Ball>& result = *balls;
  point.precise = std::make_shared<const PreciseCoordinates>(std::move(known));
  return result;
}

template <class Compute, class... Point>
int ExactGeometry::homogeneous_sign(const Compute& compute, const Point&... points) const {
  if ((precise(points).is_spread || ...)) {
    int sign = compute(spread<WideExponentBall>(points)...).sign();
    if (sign == 0) sign = compute(spread<MultiprecisionBall>(points)...).sign();
    if (sign != 0) return sign;
  }
  return sign_of(compute(exact(points)...));
}

namespace {

std::array<BoundedNumber, 2> products_of_turn(const ExactPoint& a, const ExactPoint& b,
                                              const ExactPoint& c, PlaneProjection p) {
  return {(bounded(b, p.u) - bounded(a, p.u)) * (bounded(c, p.v) - bounded(a, p.v)),
          (bounded(b, p.v) - bounded(a, p.v)) * (bounded(c, p.u) - bounded(a, p.u))};
}

// Returns the sum of the cotangents of the angles at c and d, times both areas. Each cotangent is a
// dot product divided by an area. Projected areas suffice because all points are in one plane. The
// arguments are the vectors from c and d to a and b.
template <class Number>
Number delaunay_turn(const Vector<Number>& ca, const Vector<Number>& cb, const Vector<Number>& da,
                     const Vector<Number>& db, PlaneProjection p) {
  const auto i = static_cast<std::size_t>(p.u), j = static_cast<std::size_t>(p.v);
  const auto area = [&](const Vector<Number>& u, const Vector<Number>& v) {
    return u[i] * v[j] - u[j] * v[i];
  };
  return dot(ca, cb) * area(db, da) + dot(da, db) * area(ca, cb);
}

template <class Number>
Vector<Number> way(const Vector<Number>& from, const Vector<Number>& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// Returns the vector times both weights.
template <class Number>
Vector<Number> way(const HomogeneousPoint<Number>& from, const HomogeneousPoint<Number>& to) {
  const auto step = [&](std::size_t i) -> Number { return to.x[i] * from.w - from.x[i] * to.w; };
  return {step(0), step(1), step(2)};
}

template <class Point>
auto delaunay_turn_of(const Point& a, const Point& b, const Point& c, const Point& d,
                      PlaneProjection p) {
  return delaunay_turn(way(c, a), way(c, b), way(d, a), way(d, b), p);
}

}  // namespace

BoundedNumber ExactGeometry::bounded_orient2d(const ExactPoint& a, const ExactPoint& b,
                                              const ExactPoint& c, PlaneProjection p) {
  const auto [left, right] = products_of_turn(a, b, c, p);
  return left - right;
}

int ExactGeometry::quick_orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                  PlaneProjection p) {
  return bounded_orient2d(a, b, c, p).sign();
}

std::array<Index, 10> ExactGeometry::vertices_of(const PointDefinition& definition) const {
  using Kind = PointDefinition::Kind;
  const auto sorted = [&](Index face) {
    Face corners = faces_[face];
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  const std::array<Index, 4>& of = definition.indices;
  std::array<Index, 10> vertices = {static_cast<Index>(definition.kind), of[0], of[1], of[2],
                                    of[3]};
  if (definition.kind == Kind::line_plane) {
    const Face face = sorted(of[2]);
    std::copy(face.begin(), face.end(), vertices.begin() + 3);
  } else if (definition.kind == Kind::three_planes) {
    std::array<Face, 3> faces = {sorted(of[0]), sorted(of[1]), sorted(of[2])};
    std::sort(faces.begin(), faces.end());
    for (std::size_t i = 0; i < 9; ++i) vertices[1 + i] = faces[i / 3][i % 3];
  }
  return vertices;
}

int ExactGeometry::quick_delaunay_sign(const ExactPoint& a, const ExactPoint& b,
                                       const ExactPoint& c, const ExactPoint& d,
                                       PlaneProjection p) {
  return delaunay_turn_of(bounded(a), bounded(b), bounded(c), bounded(d), p).sign();
}

int ExactGeometry::delaunay_sign(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                 const ExactPoint& d, PlaneProjection p) const {
  const int sign = quick_delaunay_sign(a, b, c, d, p);
  if (sign != 0) return sign;
  const DoubleDoubleBall balls =
      delaunay_turn_of(precise(a).x, precise(b).x, precise(c).x, precise(d).x, p);
  if (balls.sign() != 0 || balls.is_zero()) return balls.sign();
  const auto turn = [&](const auto&... points) { return delaunay_turn_of(points..., p); };
  return homogeneous_sign(turn, a, b, c, d);
}

int ExactGeometry::orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                            PlaneProjection p) const {
  if (is_exact(a) && is_exact(b) && is_exact(c)) {
    return transformesh::orient2d(a.center, b.center, c.center, p);
  }
  const auto [left, right] = products_of_turn(a, b, c, p);
  const int sign = (left - right).sign();
  if (sign != 0) return sign;
  if (leaves_double_range(std::abs(left.value) + std::abs(right.value))) {
    const int wide = wide_orient2d(a, b, c, p);
    if (wide != 0) return wide;
  }
  const auto i = static_cast<std::size_t>(p.u);
  const auto j = static_cast<std::size_t>(p.v);
  const Vector<DoubleDoubleBall>&pa = precise(a).x, &pb = precise(b).x, &pc = precise(c).x;
  const DoubleDoubleBall turn =
      (pb[i] - pa[i]) * (pc[j] - pa[j]) - (pb[j] - pa[j]) * (pc[i] - pa[i]);
  if (turn.sign() != 0 || turn.is_zero()) return turn.sign();

  // Expand the determinant of the rows (x, y, w) by the weights.
  const auto determinant = [&]<class Point>(const Point& u, const Point& v, const Point& w) {
    const auto minor = [&](const Point& s, const Point& t) -> decltype(s.w) {
      return s.x[i] * t.x[j] - s.x[j] * t.x[i];
    };
    return u.w * minor(v, w) - v.w * minor(u, w) + w.w * minor(u, v);
  };
  return homogeneous_sign(determinant, a, b, c);
}

namespace {

const PreciseNormal& precise(const ExactPlane& plane) {
  if (!plane.precise)
    plane.precise = std::make_shared<const PreciseNormal>(
        PreciseNormal{normal<DoubleDoubleBall>(plane.triangle)});
  return *plane.precise;
}

const ExactPlaneCoordinates& exact(const ExactPlane& plane) {
  if (!plane.exact)
    plane.exact = std::make_shared<const ExactPlaneCoordinates>(
        ExactPlaneCoordinates{homogeneous_plane<Exact>(plane.triangle)});
  return *plane.exact;
}

}  // namespace

int ExactGeometry::orient3d(const Triangle& t, const ExactPoint& point) const {
  return orient3d(ExactPlane{t}, point);
}

int ExactGeometry::orient3d(const ExactPlane& plane, const ExactPoint& point) const {
  const Triangle& t = plane.triangle;
  if (is_exact(point)) return transformesh::orient3d(t[0], t[1], t[2], point.center);

  // Evaluate in doubles; the bound includes the errors of the normal and of the ball.
  const Vec3 b = t[1] - t[0];
  const Vec3 c = t[2] - t[0];
  const Vec3 n = b.cross(c);
  const Vec3 d = point.center - t[0];
  const double size = b.norm() * c.norm();
  const double error = 16 * epsilon * size * d.norm() +
                       (n.cwiseAbs() + Vec3::Constant(8 * epsilon * size)).dot(point.radius);
  const double value = n.dot(d);
  const double bound = error * (1 + 64 * epsilon) + underflow_guard;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  if (leaves_double_range(size * d.norm())) {
    const int sign = dot(normal<WideExponentBall>(t), wide_difference(point, free(t[0]))).sign();
    if (sign != 0) return sign;
  }

  Vector<DoubleDoubleBall> step = precise(point).x;
  for (std::size_t i = 0; i < 3; ++i)
    step[i] = step[i] - DoubleDoubleBall(t[0][static_cast<int>(i)]);
  const int sign = dot(transformesh::precise(plane).normal, step).sign();
  if (sign != 0) return sign;

  const auto height = [&]<class Number>(const HomogeneousPoint<Number>& p) -> Number {
    if constexpr (std::is_same_v<Number, Exact>) {
      const ExactPlaneCoordinates& known = transformesh::exact(plane);
      return dot(known.normal, p.x) - known.offset * p.w;
    } else {
      return height_over(t, p);
    }
  };
  return homogeneous_sign(height, point);
}

int ExactGeometry::compare_coordinate(const ExactPoint& a, const ExactPoint& b, int i) const {
  const double value = a.center[i] - b.center[i];
  const double error = (a.radius[i] + b.radius[i]) * (1 + 4 * epsilon);
  if (value > error) return 1;
  if (value < -error) return -1;
  if (a.radius[i] == 0 && b.radius[i] == 0) return 0;
  const auto k = static_cast<std::size_t>(i);
  const int sign = (precise(a).x[k] - precise(b).x[k]).sign();
  if (sign != 0) return sign;
  const auto difference = [&](const auto& u, const auto& v) { return u.x[k] * v.w - v.x[k] * u.w; };
  return homogeneous_sign(difference, a, b);
}

int ExactGeometry::compare(const ExactPoint& a, const ExactPoint& b) const {
  for (int i = 0; i < 3; ++i) {
    const int sign = compare_coordinate(a, b, i);
    if (sign != 0) return sign;
  }
  return 0;
}

Vec3 ExactGeometry::position(const ExactPoint& point) const {
  if ((point.radius.array() <= epsilon / 2 * point.center.array().abs()).all()) return point.center;
  const ExactCoordinates& e = exact(point);
  return {quotient(e.x[0], e.w), quotient(e.x[1], e.w), quotient(e.x[2], e.w)};
}

ExactPoint ExactGeometry::mean(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                               const std::array<int, 3>& weights) const {
  const std::array<const ExactPoint*, 3> points{&a, &b, &c};
  const int total = weights[0] + weights[1] + weights[2];
  ExactPoint result;
  result.definition.kind = ExactPoint::Kind::mean;

  for (std::size_t k = 0; k < 3; ++k) {
    const double share = static_cast<double>(weights[k]) / total;
    result.center += share * points[k]->center;
    result.radius += share * points[k]->radius;
    result.radius += 8 * epsilon * points[k]->center.cwiseAbs();
  }
  result.radius = result.radius * (1 + 16 * epsilon) + Vec3::Constant(1e-300);

  // Compute the exact coordinates over the common denominator of all weights.
  const ExactCoordinates &ea = exact(a), &eb = exact(b), &ec = exact(c);
  const std::array<const ExactCoordinates*, 3> e{&ea, &eb, &ec};
  const std::array<Exact, 3> others{eb.w * ec.w, ea.w * ec.w, ea.w * eb.w};
  ExactCoordinates coordinates;
  coordinates.w = ea.w * others[0] * Exact(total);
  for (std::size_t i = 0; i < 3; ++i) {
    coordinates.x[i] = Exact(0);
    for (std::size_t k = 0; k < 3; ++k) {
      coordinates.x[i] = coordinates.x[i] + e[k]->x[i] * others[k] * Exact(weights[k]);
    }
  }
  result.exact = std::make_shared<const ExactCoordinates>(std::move(coordinates));
  return result;
}

}  // namespace transformesh
