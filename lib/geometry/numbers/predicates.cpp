#include "geometry/numbers/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/numbers/double_double_ball.h"
#include "geometry/numbers/exact_number.h"
#include "geometry/numbers/fixed_integer.h"
#include "geometry/numbers/homogeneous.h"
#include "geometry/numbers/machine_epsilon.h"
#include "geometry/numbers/monomial_sum.h"
#include "geometry/numbers/multiprecision_ball.h"
#include "geometry/numbers/number_vector.h"
#include "geometry/numbers/wide_exponent_ball.h"
#include "geometry/numbers/word_determinant.h"
#include "support/elementary/double_double.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

using Exact = ExactNumber;

// Error bounds of Shewchuk 1997, relative to the sums of absolute products.
constexpr double bound_3d = (7.0 + 64.0 * machine_epsilon) * machine_epsilon;
constexpr double bound_2d = (3.0 + 16.0 * machine_epsilon) * machine_epsilon;

// Returns the sign of a computed determinant, or 0 if its error bound is too large.
int filtered_sign(double determinant, double bound) {
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return 0;
}

/// True if expansions of determinants of such coordinates neither overflow nor underflow.
bool is_moderate(const Vec3& p) {
  const auto is_usual = [](double x) {
    return x == 0 || (std::abs(x) > 0x1p-200 && std::abs(x) < 0x1p200);
  };
  return is_usual(p[0]) && is_usual(p[1]) && is_usual(p[2]);
}

// Returns the differences of all other numbers from the first one, as multiples of `scale`.
template <std::size_t count>
std::array<std::int64_t, count - 1> one_word_ways(const CommonScale<count>& scale) {
  std::array<std::int64_t, count - 1> ways;
  const auto first = static_cast<std::int64_t>(scale.template multiple<std::uint64_t>(0));
  for (std::size_t i = 1; i < count; ++i)
    ways[i - 1] = static_cast<std::int64_t>(scale.template multiple<std::uint64_t>(i)) - first;
  return ways;
}

template <std::size_t count>
std::array<FixedInteger<2>, count - 1> two_word_ways(const CommonScale<count>& scale) {
  const auto numbers = two_word_multiples(scale);
  std::array<FixedInteger<2>, count - 1> ways;
  for (std::size_t i = 1; i < count; ++i) ways[i - 1] = numbers[i] - numbers[0];
  return ways;
}

// Evaluates the determinant in integers, for which coordinates are scaled per axis. Returns nothing
// if the magnitudes of coordinates differ too much.
std::optional<int> integer_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const CommonScale<4> x({a[0], b[0], c[0], d[0]});
  const CommonScale<4> y({a[1], b[1], c[1], d[1]});
  const CommonScale<4> z({a[2], b[2], c[2], d[2]});
  const int bits = std::max({x.bits(), y.bits(), z.bits()});
  if (bits <= one_word_bits) {
    const auto u = one_word_ways(x), v = one_word_ways(y), w = one_word_ways(z);
    return sign_of_word_determinant({{{u[0], v[0], w[0]}, {u[1], v[1], w[1]}, {u[2], v[2], w[2]}}});
  }
  if (bits > two_word_bits) return {};
  const auto u = two_word_ways(x), v = two_word_ways(y), w = two_word_ways(z);
  const auto minor = [](const auto& s, const auto& t) { return s[0] * t[1] - s[1] * t[0]; };
  return (minor(v, w) * u[2] + minor(w, u) * v[2] + minor(u, v) * w[2]).sign();
}

std::optional<int> integer_orient2d(const Vec3& a, const Vec3& b, const Vec3& c,
                                    PlaneProjection p) {
  const CommonScale<3> x({a[p.u], b[p.u], c[p.u]}), y({a[p.v], b[p.v], c[p.v]});
  const int bits = std::max(x.bits(), y.bits());
  if (bits <= one_word_bits) {
    const auto u = one_word_ways(x), v = one_word_ways(y);
    return sign_of_word(word_minor(u[0], u[1], v[0], v[1]));
  }
  if (bits > two_word_bits) return {};
  const auto u = two_word_ways(x), v = two_word_ways(y);
  return (u[0] * v[1] - v[0] * u[1]).sign();
}

bool share_coordinate(const Vec3& a, const Vec3& b, const Vec3& c, int i) {
  return a[i] == b[i] && b[i] == c[i];
}

// Determinants are expanded in coordinates: differences of coordinates would lose small numbers.
using DigitsOfPoint = std::array<BinaryDigits, 3>;

DigitsOfPoint digits_of(const Vec3& p) {
  return {BinaryDigits(p[0]), BinaryDigits(p[1]), BinaryDigits(p[2])};
}

void add_determinant(MonomialSum& sum, const DigitsOfPoint& a, const DigitsOfPoint& b,
                     const DigitsOfPoint& c) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add(a[i], b[j], c[k]);
    sum.subtract(a[i], b[k], c[j]);
  }
}

int sum_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const DigitsOfPoint p = digits_of(a), q = digits_of(b), r = digits_of(c), s = digits_of(d);
  MonomialSum sum;
  add_determinant(sum, q, r, s);
  add_determinant(sum, r, p, s);
  add_determinant(sum, p, q, s);
  add_determinant(sum, q, p, r);
  return sum.sign();
}

int sum_orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection p) {
  const BinaryDigits one(1);
  MonomialSum sum;
  const auto add_minor = [&](const Vec3& u, const Vec3& v) {
    sum.add(BinaryDigits(u[p.u]), BinaryDigits(v[p.v]), one);
    sum.subtract(BinaryDigits(v[p.u]), BinaryDigits(u[p.v]), one);
  };
  add_minor(a, b);
  add_minor(b, c);
  add_minor(c, a);
  return sum.sign();
}

// Tests for points in a plane perpendicular to an axis first, the most frequent cause of zeros.
int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  for (int i = 0; i < 3; ++i)
    if (share_coordinate(a, b, c, i) && c[i] == d[i]) return 0;
  if (const auto sign = integer_orient3d(a, b, c, d)) return *sign;
  return sum_orient3d(a, b, c, d);
}

// Returns the exact sign of a b - c d. If both products round to the same number, their rounding
// errors decide.
int sign_of_minor(double a, double b, double c, double d) {
  const elementary::DoubleDouble ab = elementary::exact_product(a, b);
  const elementary::DoubleDouble cd = elementary::exact_product(c, d);
  return ab.high != cd.high ? (ab.high > cd.high ? 1 : -1)
                            : (ab.low > cd.low ? 1 : 0) - (ab.low < cd.low ? 1 : 0);
}

// Returns the sign if all differences of coordinates are exact in doubles, otherwise nothing. This
// is faster than exact arithmetic for coordinates on a lattice.
std::optional<int> quick_orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection p) {
  if (!(is_moderate(a) && is_moderate(b) && is_moderate(c))) return {};
  bool is_exact = true;
  const auto minus = [&](double x, double y) {
    const elementary::DoubleDouble difference = elementary::exact_sum(x, -y);
    is_exact &= difference.low == 0;
    return difference.high;
  };
  const double bu = minus(b[p.u], a[p.u]), bv = minus(b[p.v], a[p.v]);
  const double cu = minus(c[p.u], a[p.u]), cv = minus(c[p.v], a[p.v]);
  if (!is_exact) return {};
  return sign_of_minor(bu, cv, bv, cu);
}

int exact_orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection p) {
  if (share_coordinate(a, b, c, p.u) || share_coordinate(a, b, c, p.v)) return 0;
  if (const auto sign = quick_orient2d(a, b, c, p)) return *sign;
  if (const auto sign = integer_orient2d(a, b, c, p)) return *sign;
  return sum_orient2d(a, b, c, p);
}

constexpr PlaneProjection along(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double bycz = by * cz, bzcy = bz * cy;
  const double bzcx = bz * cx, bxcz = bx * cz;
  const double bxcy = bx * cy, bycx = by * cx;
  const double determinant = dx * (bycz - bzcy) + dy * (bzcx - bxcz) + dz * (bxcy - bycx);
  const double permanent = std::abs(dx) * (std::abs(bycz) + std::abs(bzcy)) +
                           std::abs(dy) * (std::abs(bzcx) + std::abs(bxcz)) +
                           std::abs(dz) * (std::abs(bxcy) + std::abs(bycx));
  const int sign = filtered_sign(determinant, bound_3d * permanent + underflow_guard);
  return sign != 0 ? sign : exact_orient3d(a, b, c, d);
}

OrientedPlane::OrientedPlane(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a), b_(b), c_(c) {
  const Vec3 u = b - a, v = c - a;
  const Vec3 plus(u[1] * v[2], u[2] * v[0], u[0] * v[1]);
  const Vec3 minus(u[2] * v[1], u[0] * v[2], u[1] * v[0]);
  normal_ = plus - minus;
  size_ = plus.cwiseAbs() + minus.cwiseAbs();
}

int OrientedPlane::filtered_side_of(const Vec3& point) const {
  const Vec3 d = point - a_;
  const double determinant = d[0] * normal_[0] + d[1] * normal_[1] + d[2] * normal_[2];
  const double permanent =
      std::abs(d[0]) * size_[0] + std::abs(d[1]) * size_[1] + std::abs(d[2]) * size_[2];
  return filtered_sign(determinant, bound_3d * permanent + underflow_guard);
}

int OrientedPlane::side_of(const Vec3& point) const {
  const int sign = filtered_side_of(point);
  return sign != 0 ? sign : orient3d(a_, b_, c_, point);
}

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, PlaneProjection p) {
  const double left = (b[p.u] - a[p.u]) * (c[p.v] - a[p.v]);
  const double right = (b[p.v] - a[p.v]) * (c[p.u] - a[p.u]);
  const double permanent = std::abs(left) + std::abs(right);
  const int sign = filtered_sign(left - right, bound_2d * permanent + underflow_guard);
  return sign != 0 ? sign : exact_orient2d(a, b, c, p);
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orient2d(a, b, c, along(0)) == 0 && orient2d(a, b, c, along(1)) == 0 &&
         orient2d(a, b, c, along(2)) == 0;
}

PlaneProjection projection_of(const Triangle& t) {
  const Vec3 b = t[1] - t[0], c = t[2] - t[0];
  const Vec3 left(b[1] * c[2], b[2] * c[0], b[0] * c[1]);
  const Vec3 right(b[2] * c[1], b[0] * c[2], b[1] * c[0]);
  const Vec3 normal = left - right;
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const auto facing = [](int i, int turn) {
    const PlaneProjection projection = along(i % 3);
    return turn > 0 ? projection : PlaneProjection{projection.v, projection.u};
  };
  const double error = bound_2d * (std::abs(left[axis]) + std::abs(right[axis])) + underflow_guard;
  const int sign = filtered_sign(normal[axis], error);
  if (sign != 0) return facing(axis, sign);
  // The largest estimated coordinate of a sliver's normal may be zero, so exact signs decide.
  for (int i = axis; i < axis + 3; ++i) {
    const int turn = orient2d(t[0], t[1], t[2], along(i % 3));
    if (turn != 0) return facing(i, turn);
  }
  return {};
}

namespace {

bool is_moderate(const Triangle& t) {
  return is_moderate(t[0]) && is_moderate(t[1]) && is_moderate(t[2]);
}

// Returns the sign of `compute`, applied to the normals of both triangles. Tries balls (numbers
// with an error bound) first, and evaluates exact numbers if these do not decide.
template <class Compute>
int sign_by_normals(const Triangle& first, const Triangle& second, const Compute& compute) {
  const auto by_coordinates = [&]<class Ball>(const Ball&) {
    return compute(homogeneous_normal<Ball>(first), homogeneous_normal<Ball>(second)).sign();
  };
  int sign = 0;
  if (is_moderate(first) && is_moderate(second)) {
    sign = compute(normal<DoubleDoubleBall>(first), normal<DoubleDoubleBall>(second)).sign();
  } else {
    sign = by_coordinates(WideExponentBall());
    if (sign == 0) sign = by_coordinates(MultiprecisionBall());
  }
  return sign != 0 ? sign : sign_of(compute(normal<Exact>(first), normal<Exact>(second)));
}

}  // namespace

int normals_dot(const Triangle& first, const Triangle& second) {
  const Vec3 n = (first[1] - first[0]).cross(first[2] - first[0]);
  const Vec3 m = (second[1] - second[0]).cross(second[2] - second[0]);
  // The error of a normal's coordinate is at most 4 epsilon times the product of two edge lengths.
  const double size = (first[1] - first[0]).norm() * (first[2] - first[0]).norm() *
                      (second[1] - second[0]).norm() * (second[2] - second[0]).norm();
  const int sign = filtered_sign(n.dot(m), 32 * machine_epsilon * size + underflow_guard);
  if (sign != 0) return sign;
  return sign_by_normals(first, second, [](const auto& u, const auto& v) { return dot(u, v); });
}

int normals_cross(const Triangle& first, const Triangle& second, int coordinate) {
  const Vec3 n = (first[1] - first[0]).cross(first[2] - first[0]);
  const Vec3 m = (second[1] - second[0]).cross(second[2] - second[0]);
  const double size = (first[1] - first[0]).norm() * (first[2] - first[0]).norm() *
                      (second[1] - second[0]).norm() * (second[2] - second[0]).norm();
  const int sign =
      filtered_sign(n.cross(m)[coordinate], 32 * machine_epsilon * size + underflow_guard);
  if (sign != 0) return sign;
  const auto i = static_cast<std::size_t>(coordinate);
  return sign_by_normals(first, second,
                         [&](const auto& u, const auto& v) { return cross(u, v)[i]; });
}

std::vector<Index> degenerate_faces(const Mesh& mesh) {
  constexpr std::size_t faces_per_task = 4096;  // affects time only
  std::vector<char> is_degenerate(mesh.faces.size());
  parallel_for(mesh.faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      is_degenerate[f] = collinear(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
  });
  std::vector<Index> result;
  for (std::size_t f = 0; f < is_degenerate.size(); ++f)
    if (is_degenerate[f]) result.push_back(static_cast<Index>(f));
  return result;
}

int compare_positions(const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

}  // namespace transformesh
