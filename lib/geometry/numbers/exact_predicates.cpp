// Predicates of points that are given by their definition. They try balls (numbers with an error
// bound) in doubles first, then double-double, then exact numbers.
#include <cmath>
#include <limits>
#include <type_traits>

#include "geometry/numbers/exact_coordinates.h"
#include "geometry/numbers/machine_epsilon.h"
#include "geometry/numbers/number_vector.h"

namespace transformesh {
namespace {

template <class Number>
using Vector = NumberVector<Number>;

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

std::array<BoundedNumber, 2> products_of_turn(const ExactPoint& a, const ExactPoint& b,
                                              const ExactPoint& c, PlaneProjection p) {
  return {(bounded(b, p.u) - bounded(a, p.u)) * (bounded(c, p.v) - bounded(a, p.v)),
          (bounded(b, p.v) - bounded(a, p.v)) * (bounded(c, p.u) - bounded(a, p.u))};
}

// Returns the sum of the cotangents of the angles at c and d, multiplied by twice the area of each
// of the two triangles. Each cotangent is a dot product divided by twice an area. Projected areas
// suffice because all points are in one plane. The arguments are the vectors from c and d to a and
// b.
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

// Returns the vector between two points in homogeneous coordinates, multiplied by both weights.
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

const PreciseNormal& precise(const ExactPlane& plane) {
  if (!plane.precise)
    plane.precise = std::make_shared<const PreciseNormal>(
        PreciseNormal{normal<DoubleDoubleBall>(plane.triangle)});
  return *plane.precise;
}

const ExactPlaneCoordinates& exact(const ExactPlane& plane) {
  if (!plane.exact)
    plane.exact = std::make_shared<const ExactPlaneCoordinates>(
        ExactPlaneCoordinates{homogeneous_plane<ExactNumber>(plane.triangle)});
  return *plane.exact;
}

}  // namespace

template <class Compute, class... Point>
int ExactGeometry::homogeneous_sign(const Compute& compute, const Point&... points) const {
  if ((precise(points).is_spread || ...)) {
    int sign = compute(spread<WideExponentBall>(points)...).sign();
    if (sign == 0) sign = compute(spread<MultiprecisionBall>(points)...).sign();
    if (sign != 0) return sign;
  }
  return sign_of(compute(exact(points)...));
}

BoundedNumber ExactGeometry::bounded_orient2d(const ExactPoint& a, const ExactPoint& b,
                                              const ExactPoint& c, PlaneProjection p) {
  const auto [left, right] = products_of_turn(a, b, c, p);
  return left - right;
}

int ExactGeometry::quick_orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                                  PlaneProjection p) {
  return bounded_orient2d(a, b, c, p).sign();
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

int ExactGeometry::orient3d(const Triangle& t, const ExactPoint& point) const {
  return orient3d(ExactPlane{t}, point);
}

int ExactGeometry::orient3d(const ExactPlane& plane, const ExactPoint& point) const {
  const Triangle& t = plane.triangle;
  if (is_exact(point)) return transformesh::orient3d(t[0], t[1], t[2], point.center);

  // Evaluate the sign in doubles. The bound includes the errors of the normal and of the point's
  // ball.
  const Vec3 b = t[1] - t[0];
  const Vec3 c = t[2] - t[0];
  const Vec3 n = b.cross(c);
  const Vec3 d = point.center - t[0];
  const double size = b.norm() * c.norm();
  const double error =
      16 * machine_epsilon * size * d.norm() +
      (n.cwiseAbs() + Vec3::Constant(8 * machine_epsilon * size)).dot(point.radius);
  const double value = n.dot(d);
  const double bound = error * (1 + 64 * machine_epsilon) + underflow_guard;
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
    if constexpr (std::is_same_v<Number, ExactNumber>) {
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
  const double error = (a.radius[i] + b.radius[i]) * (1 + 4 * machine_epsilon);
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

}  // namespace transformesh
