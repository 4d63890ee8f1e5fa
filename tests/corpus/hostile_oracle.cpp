#include "corpus/hostile_oracle.h"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "corpus/build.h"
#include "tm/mesh/digits.h"

namespace transformesh::corpus {
namespace {

using Wide = __float128;
using Rational = boost::multiprecision::cpp_rational;
using WidePoint = std::array<Wide, 3>;
using Corners = std::array<Vec3, 3>;

Wide absolute(Wide x) { return x < 0 ? -x : x; }

/// The sign of a determinant of differences: in 113 bits where these decide, else in rationals.
template <typename Number>
Number determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, Number& size) {
  std::array<std::array<Number, 3>, 3> m;
  const std::array<const Vec3*, 3> rows = {&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      m[i][static_cast<std::size_t>(k)] = Number((*rows[i])[k]) - Number(p[k]);
  const auto minor = [&](std::size_t i, std::size_t j) -> std::array<Number, 2> {
    return {m[1][i] * m[2][j], m[1][j] * m[2][i]};
  };
  Number sum = 0;
  size = 0;
  const auto add = [&](std::size_t k, std::size_t i, std::size_t j) {
    const auto [plus, minus] = minor(i, j);
    sum += m[0][k] * (plus - minus);
    const Number left = m[0][k] * plus, right = m[0][k] * minus;
    size += (left < 0 ? Number(-left) : left) + (right < 0 ? Number(-right) : right);
  };
  add(0, 1, 2), add(1, 2, 0), add(2, 0, 1);
  return sum;
}

int side_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  Wide size = 0;
  const Wide sum = determinant<Wide>(a, b, c, p, size);
  if (absolute(sum) > size * Wide(0x1p-106)) return sum > 0 ? 1 : -1;
  Rational exact_size = 0;
  const Rational exact = determinant<Rational>(a, b, c, p, exact_size);
  return exact.sign();
}

/// The side of a line through two points in the yz plane.
int side_of(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Wide left = (Wide(a.y()) - p.y()) * (Wide(b.z()) - p.z());
  const Wide right = (Wide(a.z()) - p.z()) * (Wide(b.y()) - p.y());
  if (absolute(left - right) > (absolute(left) + absolute(right)) * Wide(0x1p-106))
    return left > right ? 1 : -1;
  const auto minus = [](double x, double y) { return Rational(Rational(x) - Rational(y)); };
  const Rational exact =
      minus(a.y(), p.y()) * minus(b.z(), p.z()) - minus(a.z(), p.z()) * minus(b.y(), p.y());
  return exact.sign();
}

Corners corners_of(const Mesh& mesh, const Face& face) {
  return {mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]};
}

/// Along the ray in direction x; none where it meets an edge or the point lies on a face.
std::optional<int> winding_at(const Mesh& mesh, const Vec3& p) {
  int winding = 0;
  for (const Face& face : mesh.faces) {
    const Corners t = corners_of(mesh, face);
    if (std::max({t[0].x(), t[1].x(), t[2].x()}) < p.x()) continue;
    const int first = side_of(t[0], t[1], p), second = side_of(t[1], t[2], p),
              third = side_of(t[2], t[0], p);
    if (std::max({first, second, third}) > 0 && std::min({first, second, third}) < 0) continue;
    if (first == 0 || second == 0 || third == 0) {
      if (first == 0 && second == 0 && third == 0) continue;  // seen edge on: no area
      return std::nullopt;
    }
    const int side = side_of(t[0], t[1], t[2], p);
    if (side == 0) return std::nullopt;
    if (side == first) winding += side;
  }
  return winding;
}

WidePoint difference(const Vec3& a, const Vec3& b) {
  return {Wide(a[0]) - b[0], Wide(a[1]) - b[1], Wide(a[2]) - b[2]};
}
Wide dot(const WidePoint& a, const WidePoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The squared distance of the origin from a + s u + t v within the triangle.
Wide squared_distance(const Corners& corners, const Vec3& p) {
  const WidePoint a = difference(corners[0], p), b = difference(corners[1], p),
                  c = difference(corners[2], p);
  const auto segment = [&](const WidePoint& from, const WidePoint& to) {
    const WidePoint along = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    const Wide length = dot(along, along);
    Wide share = length > 0 ? -dot(from, along) / length : Wide(0);
    share = share < 0 ? Wide(0) : share > 1 ? Wide(1) : share;
    const WidePoint q = {from[0] + share * along[0], from[1] + share * along[1],
                         from[2] + share * along[2]};
    return dot(q, q);
  };
  const Wide least = std::min({segment(a, b), segment(b, c), segment(c, a)});
  const auto cross = [](const WidePoint& u, const WidePoint& v) -> WidePoint {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const WidePoint u = difference(corners[1], corners[0]), v = difference(corners[2], corners[0]);
  const WidePoint n = cross(u, v);
  const Wide nn = dot(n, n);
  if (!(nn > 0)) return least;
  const bool is_over =
      dot(cross(a, b), n) > 0 && dot(cross(b, c), n) > 0 && dot(cross(c, a), n) > 0;
  const Wide height = dot(a, n);
  return is_over ? std::min(least, height * height / nn) : least;
}

bool is_near(const Mesh& mesh, const Vec3& p, double reach) {
  for (const Face& face : mesh.faces) {
    const Corners t = corners_of(mesh, face);
    const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    if (((p - low).array() < -reach).any() || ((p - high).array() > reach).any()) continue;
    if (squared_distance(t, p) <= Wide(reach) * reach) return true;
  }
  return false;
}

/// A point beside a face of the mesh: often close to a corner, at any distance between the
/// tolerance and the size of the face.
Vec3 draw_sample(const Mesh& mesh, double epsilon, Random& random) {
  const Corners t = corners_of(mesh, mesh.faces[random.below(mesh.faces.size())]);
  Vec3 weights;
  for (double& w : weights) w = std::pow(2, -random.uniform(0, random.below(2) == 0 ? 3 : 60));
  weights /= weights.sum();
  const Vec3 base = weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
  const double size = base.cwiseAbs().maxCoeff();
  const double distance = size * std::pow(2, random.uniform(std::log2(epsilon) + 5, 1));
  return base + distance * random.point(-1, 1);
}

}  // namespace

LocalSamples sample_locally(const Mesh& input, const Mesh& output, Scalar type, int samples,
                            double spacings, std::uint64_t seed) {
  Random random(seed);
  LocalSamples result;
  const double epsilon = type == Scalar::float32 ? 0x1p-23 : 0x1p-52;
  for (int i = 0; i < samples; ++i) {
    const bool is_of_output = i % 4 == 0 && !output.faces.empty();
    const Vec3 p = draw_sample(is_of_output ? output : input, epsilon, random);
    const double spacing = spacing_around(p, type);
    if (!p.allFinite() || is_near(input, p, spacings * spacing)) {
      ++result.undecided;
      continue;
    }
    const std::optional<int> in = winding_at(input, p), out = winding_at(output, p);
    if (!in || !out) {
      ++result.undecided;
      continue;
    }
    ++result.tested;
    if (*out == (*in >= 1 ? 1 : 0)) continue;
    if (++result.wrong > 1) continue;
    std::ostringstream text;
    text.precision(17);
    text << "at " << p.transpose() << " the input winds " << *in << " times, the output " << *out;
    result.first_wrong = text.str();
  }
  return result;
}

}  // namespace transformesh::corpus
