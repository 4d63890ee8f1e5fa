#include "clean/rounding/local_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace transformesh {
namespace {

/// A direction or a face that leads along an axis by less than 2^-flatness is flat along it.
constexpr int flatness = 10;
/// A mesh reaches far where it does 2^far_exponent times farther than half of its vertices lie.
constexpr int far_exponent = 40;

double spacing_of(double x, Scalar coordinate) { return spacing_around(Vec3(x, 0, 0), coordinate); }

}  // namespace

Vec3 unit_normal(const Triangle& t) {
  std::size_t corner = 0;
  double longest = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = (t[(i + 2) % 3] - t[(i + 1) % 3]).stableNorm();
    if (length <= longest) continue;
    longest = length;
    corner = i;
  }
  const Vec3 first = (t[(corner + 1) % 3] - t[corner]).stableNormalized();
  const Vec3 second = (t[(corner + 2) % 3] - t[corner]).stableNormalized();
  return first.cross(second).stableNormalized();
}

double height_over(const Triangle& t, const Vec3& unit_normal, const Vec3& point) {
  const auto is_nearer = [&](const Vec3& a, const Vec3& b) {
    return (a - point).stableNorm() < (b - point).stableNorm();
  };
  return unit_normal.dot(point - *std::min_element(t.begin(), t.end(), is_nearer));
}

LineDistance distance_from_line(const Vec3& a, const Vec3& b, const Vec3& point) {
  const bool is_a_nearer = (point - a).stableNorm() <= (point - b).stableNorm();
  const Vec3& near = is_a_nearer ? a : b;
  const Vec3 along = ((is_a_nearer ? b : a) - near).stableNormalized();
  const Vec3 to = point - near;
  const Vec3 turned = along.cross(to);
  return {turned.stableNorm(), -to.dot(along), turned.stableNormalized().cross(along)};
}

Vec3 Spacings::leads(const Vec3& direction) const {
  if (!are_per_axis) return Vec3::Ones();
  return std::ldexp(1, flatness) * direction.cwiseAbs().cwiseMin(std::ldexp(1, -flatness));
}

double Spacings::along(const Vec3& direction, const Vec3& point) const {
  if (!are_per_axis || direction.isZero(0)) return spacing_around(point, type);
  const Vec3 shares = leads(direction);
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max(most, shares[i] * spacing_of(point[i], type));
  return most;
}

Vec3 Spacings::on_face(const Vec3& extent, const Vec3& corner) const {
  if (!are_per_axis) return Vec3::Constant(spacing_around(corner, type));
  Vec3 spacings;
  for (int i = 0; i < 3; ++i) spacings[i] = spacing_of(corner[i], type);
  Vec3 most = spacings;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3 && extent[i] > 0; ++k) {
      if (!(extent[k] > 0)) continue;
      const int lead = std::min(0, flatness + std::ilogb(extent[i]) - std::ilogb(extent[k]));
      most[i] = std::max(most[i], std::ldexp(spacings[k], lead));
    }
  return most;
}

Spacings spacings_for(const Mesh& mesh, Scalar type) {
  std::vector<double> sizes;
  for (const Vec3& p : mesh.positions) sizes.push_back(p.cwiseAbs().maxCoeff());
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return {type, std::ldexp(*std::max_element(middle, sizes.end()), -far_exponent) > *middle};
}

}  // namespace transformesh
