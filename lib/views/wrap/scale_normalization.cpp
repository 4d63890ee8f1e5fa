#include "views/wrap/scale_normalization.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

// Range of accepted sizes. Sizes outside of it are close to the limits of doubles.
constexpr double least_size = 1e-290;
constexpr double largest_size = 1e290;
/// Least ratio of the length of details to the largest coordinate. Details are then at least
/// thousands of times larger than rounding errors.
constexpr double least_detail = 1e-12;

Vec3 scaled(const Vec3& point, int exponent) {
  return point.unaryExpr([exponent](double value) { return std::ldexp(value, exponent); });
}

}  // namespace

ScaleNormalization::ScaleNormalization(double size) {
  if (!(size >= least_size && size <= largest_size)) {
    const bool is_large = size > largest_size;
    throw InputError("the points are too " + std::string(is_large ? "far apart" : "close") +
                     " to wrap, " + shortest_text(size) + " across: scale them " +
                     (is_large ? "down" : "up"));
  }
  exponent_ = std::ilogb(size);
}

double ScaleNormalization::to_unit(double length) const { return std::ldexp(length, -exponent_); }
double ScaleNormalization::from_unit(double length) const { return std::ldexp(length, exponent_); }

std::vector<Vec3> ScaleNormalization::to_unit(std::span<const Vec3> points) const {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& point : points) result.push_back(scaled(point, -exponent_));
  return result;
}

void ScaleNormalization::from_unit(Mesh& mesh) const {
  for (Vec3& position : mesh.positions) position = scaled(position, exponent_);
}

double diagonal_of(std::span<const Vec3> points) {
  Mesh cloud;
  cloud.positions.assign(points.begin(), points.end());
  const Box box = bounding_box(cloud);
  return (box.max() - box.min()).stableNorm();
}

std::vector<std::size_t> first_equals(std::span<const Vec3> points) {
  const auto key = [&](std::size_t i) {
    return std::tuple(points[i].x(), points[i].y(), points[i].z());
  };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(key(a), a) < std::pair(key(b), b);
  });
  std::vector<std::size_t> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || points[order[i]] != points[order[i - 1]];
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

void check_detail(std::span<const Vec3> points, double detail, double largest) {
  double reach = 0;
  for (const Vec3& point : points) reach = std::max(reach, point.cwiseAbs().maxCoeff());
  if (!(detail >= least_detail * reach)) {
    throw InputError(
        "coordinates reach " + shortest_text(reach) + ", so details of " + shortest_text(detail) +
        " cannot be resolved: move the points to the origin, or wrap them more coarsely");
  }
  if (!(detail >= least_detail * largest)) {
    throw InputError("details of " + shortest_text(detail) +
                     " cannot be resolved beside lengths of " + shortest_text(largest) +
                     ": give lengths that differ less");
  }
}

void check_wrap(Mesh& mesh) {
  const ManifoldReport report = check_manifold(mesh);
  const bool is_sound = report.is_manifold() && report.is_oriented() && report.is_closed();
  if (mesh.faces.empty() || !is_sound)
    throw GoalError(
        "no closed surface fits these points: check that their normals point outwards, and that no "
        "point is far off");
  if (volume(mesh) >= 0) return;
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
}

}  // namespace transformesh
