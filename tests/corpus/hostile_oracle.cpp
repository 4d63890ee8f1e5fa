#include "corpus/hostile_oracle.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include "corpus/build.h"
#include "mesh/coordinate_spacing.h"

namespace transformesh::corpus {
namespace {

using Wide = __float128;
using Rational = boost::multiprecision::cpp_rational;
using Corners = std::array<Vec3, 3>;

Wide absolute(Wide x) { return x < 0 ? -x : x; }

/// Returns the sign of a determinant of differences: in 113-bit floating point if that decides,
/// otherwise in rationals.
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

/// Returns the side of a line through two points in the yz plane.
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

/// Returns the winding number along the ray in direction x; none if the ray meets an edge or the
/// point lies on a face.
std::optional<int> winding_at(const Mesh& mesh, const Vec3& p) {
  int winding = 0;
  for (const Face& face : mesh.faces) {
    const Corners t = corners_of(mesh, face);
    if (std::max({t[0].x(), t[1].x(), t[2].x()}) < p.x()) continue;
    const int first = side_of(t[0], t[1], p), second = side_of(t[1], t[2], p),
              third = side_of(t[2], t[0], p);
    if (std::max({first, second, third}) > 0 && std::min({first, second, third}) < 0) continue;
    if (first == 0 || second == 0 || third == 0) {
      if (first == 0 && second == 0 && third == 0) continue;  // the projection has no area
      return std::nullopt;
    }
    const int side = side_of(t[0], t[1], t[2], p);
    if (side == 0) return std::nullopt;
    if (side == first) winding += side;
  }
  return winding;
}

/// The half plane of weights (u, v) of two corners with at + along_u u + along_v v >= 0.
struct HalfPlane {
  Wide at, along_u, along_v;
  Wide operator()(const std::array<Wide, 2>& w) const {
    return at + along_u * w[0] + along_v * w[1];
  }
};

/// Returns the part of a convex polygon inside the half plane.
std::vector<std::array<Wide, 2>> cut(const std::vector<std::array<Wide, 2>>& polygon,
                                     const HalfPlane& half_plane) {
  std::vector<std::array<Wide, 2>> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const Wide start = half_plane(from), end = half_plane(to);
    if (start >= 0) result.push_back(from);
    if ((start < 0) == (end < 0)) continue;
    const Wide share = start / (start - end);
    result.push_back({from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])});
  }
  return result;
}

/// Returns true if the face may reach the point when each corner moves by up to its reach along
/// each axis. The reach of a point of the face is interpolated between the corners.
bool may_reach(const Corners& t, const std::array<double, 3>& reach, const Vec3& p) {
  std::vector<std::array<Wide, 2>> weights = {{0, 0}, {1, 0}, {0, 1}};
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {1, -1}) {
      const auto slack = [&](std::size_t i) -> Wide {
        return reach[i] + sign * (Wide(t[i][k]) - p[k]);
      };
      weights = cut(weights, {slack(0), slack(1) - slack(0), slack(2) - slack(0)});
      if (weights.empty()) return false;
    }
  }
  return true;
}

/// Returns true if a face of the mesh may reach the point when its corners move. A corner may move
/// by `spacings` times the spacing at the corner or at the point, whichever is larger.
bool is_near(const Mesh& mesh, const Vec3& p, double spacings, Scalar type) {
  const double least = spacing_around(p, type);
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& face) {
    Corners t = corners_of(mesh, face);
    const auto is_smaller = [](const Vec3& a, const Vec3& b) {
      return a.cwiseAbs().maxCoeff() < b.cwiseAbs().maxCoeff();
    };
    std::swap(t[0], *std::min_element(t.begin(), t.end(), is_smaller));
    std::array<double, 3> reach;
    for (std::size_t i = 0; i < 3; ++i)
      reach[i] = spacings * std::max(least, spacing_around(t[i], type));
    return may_reach(t, reach, p);
  });
}

/// Returns a point near a face of the mesh, often close to a corner, at any distance between the
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
    if (!p.allFinite() || is_near(input, p, spacings, type)) {
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
