#include "geometry/search/float_box.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t points_per_task = 4096;  ///< affects time only
/// Largest number of points from which quantiles are estimated. A choice: the quantiles determine
/// the origin of boxes, which affects time only.
constexpr std::size_t most_sampled_points = 1024;
/// Magnitudes below this are hardly distinguished by floats.
constexpr double smallest_usual = 1e-30;

FloatBox box_of_corners(const Vec3& a, const Vec3& b, const Vec3& c) {
  return float_box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
}

/// Returns a quantile of value(point), estimated from a sample of the points. `share`, in [0, 1),
/// is the fraction of values below it.
template <class Value>
double quantile(std::span<const Vec3> points, double share, const Value& value) {
  const std::size_t stride = points.size() / most_sampled_points + 1;
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); i += stride) values.push_back(value(points[i]));
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Returns the median of the points along each axis, on which a few distant points have no
// influence.
Vec3 middle_of_most(std::span<const Vec3> points) {
  const auto middle = [&](int axis) {
    return quantile(points, 0.5, [axis](const Vec3& p) { return p[axis]; });
  };
  return {middle(0), middle(1), middle(2)};
}

/// Returns a monotonic function of x, similar to a logarithm with sign: it increases by 1 if the
/// magnitude doubles.
double exponent_and_fraction(double x) {
  const auto bits = static_cast<double>(std::bit_cast<std::uint64_t>(std::abs(x)));
  return std::copysign(bits * 0x1p-52, x);
}

Vec3 exponents(const Vec3& p) {
  return {exponent_and_fraction(p[0]), exponent_and_fraction(p[1]), exponent_and_fraction(p[2])};
}

// Returns half of the largest distance of a point from the origin along an axis. Halves are
// computed because they do not overflow.
double half_extent(std::span<const Vec3> points, const Vec3& origin) {
  std::vector<double> largest((points.size() + points_per_task - 1) / points_per_task, 0);
  parallel_for(largest.size(), 1, [&](std::size_t from, std::size_t to) {
    for (std::size_t b = from; b < to; ++b) {
      const std::size_t first = b * points_per_task;
      double size = 0;
      for (const Vec3& point :
           points.subspan(first, std::min(points_per_task, points.size() - first)))
        size = std::max(size, (point / 2 - origin / 2).cwiseAbs().maxCoeff());
      largest[b] = size;
    }
  });
  return *std::max_element(largest.begin(), largest.end());
}

}  // namespace

// Rounds up without branches, because their outcome would be unpredictable, and boxes are created
// in large numbers. Adding 0 turns -0 into 0, so that bit patterns are ordered.
float float_above(double value) {
  const float nearest = static_cast<float>(value) + 0.0F;
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  const std::int32_t up = bits < 0 ? -1 : 1;
  return std::bit_cast<float>(bits + (nearest < value ? up : 0));
}

float float_below(double value) { return -float_above(-value); }

FloatBox float_box(const Vec3& minimum, const Vec3& maximum) {
  return FloatBox(
      Eigen::Vector3f(float_below(minimum.x()), float_below(minimum.y()), float_below(minimum.z())),
      Eigen::Vector3f(float_above(maximum.x()), float_above(maximum.y()),
                      float_above(maximum.z())));
}

// Determines origin and scale. The map to floats is monotonic, so boxes that overlap in doubles
// also overlap in floats.
BoxFrame::BoxFrame(std::span<const Vec3> points) {
  if (points.empty()) return;
  origin_ = middle_of_most(points);
  const double size = half_extent(points, origin_);
  if (size > 0) scale_ = std::ldexp(1.0, std::min(1000, -std::ilogb(size)));
  for (int axis = 0; axis < 3; ++axis)
    is_wide_ |= quantile(points, 0.25, [&](const Vec3& p) {
                  const double x = std::abs(p[axis] - origin_[axis]) * scale_;
                  return x > 0 ? x : 1;
                }) < smallest_usual;
}

FloatBox BoxFrame::wide_box(const Vec3& minimum, const Vec3& maximum) const {
  return float_box(exponents(minimum - origin_), exponents(maximum - origin_));
}

std::vector<FloatBox> face_boxes(const Mesh& mesh) {
  std::vector<FloatBox> boxes(mesh.faces.size());
  parallel_for(boxes.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      boxes[f] = box_of_corners(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
  });
  return boxes;
}

std::vector<FloatBox> face_boxes(const Mesh& mesh, std::span<const Index> faces) {
  std::vector<FloatBox> boxes(faces.size());
  parallel_for(boxes.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const auto& [a, b, c] = mesh.faces[faces[i]];
      boxes[i] = box_of_corners(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
  });
  return boxes;
}

}  // namespace transformesh
