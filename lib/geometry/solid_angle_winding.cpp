#include "geometry/solid_angle_winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "support/elementary/arctangent.h"
#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t points_per_task = 4;  ///< affects time only

/// Bound of the rounding error of the real or imaginary part of a face's complex number. Unit
/// vectors produce it in fewer than 60 roundings of numbers up to 1.
constexpr double part_error = 1e-14;

/// A running sum of angles: a complex number for the angle within (-pi, pi], and a count of whole
/// turns. Angles in [0, pi] have an imaginary part of at least 0.
struct Turns {
  double real = 1;
  double imaginary = 0;
  int turns = 0;

  void add(double other_real, double other_imaginary) {
    const bool was_up = imaginary >= 0;
    const bool adds_up = other_imaginary >= 0;
    const double product_real = real * other_real - imaginary * other_imaginary;
    const double product_imaginary = real * other_imaginary + imaginary * other_real;
    const bool is_up = product_imaginary >= 0;
    if (was_up == adds_up && was_up != is_up) turns += was_up ? 1 : -1;
    real = product_real;
    imaginary = product_imaginary;
  }
  void rescale() {
    const double size = std::max(std::abs(real), std::abs(imaginary));
    real /= size;
    imaginary /= size;
  }
  double total() const {
    return turns + elementary::atan2(imaginary, real) / (2 * std::numbers::pi);
  }
};

/// Returns a power of two such that numbers up to `largest` can be squared and added without
/// overflow.
double safe_scale(double largest) {
  return largest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1;
}

}  // namespace

SolidAngleWinding::SolidAngleWinding(const Mesh& mesh) : mesh_(&mesh) {
  const Box box = bounding_box(mesh);
  largest_coordinate_ = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

BoundedWindingNumber SolidAngleWinding::sum(const Vec3& point,
                                            std::vector<Vec3>& directions) const {
  // The direction is NaN if the point is at the vertex.
  const double scale = safe_scale(std::max(largest_coordinate_, point.cwiseAbs().maxCoeff()));
  const Vec3 origin = point * scale;
  directions.resize(mesh_->positions.size());
  for (std::size_t v = 0; v < directions.size(); ++v) {
    const Vec3 offset = mesh_->positions[v] * scale - origin;
    directions[v] = offset / offset.norm();
  }

  // Half the solid angle of a face is the argument of a complex number.
  Turns turns;
  double error = 0;
  int until_rescaled = 0;
  for (const Face& face : mesh_->faces) {
    const Vec3& a = directions[face[0]];
    const Vec3& b = directions[face[1]];
    const Vec3& c = directions[face[2]];
    const double imaginary = a.dot(b.cross(c));
    const double real = 1 + a.dot(b) + b.dot(c) + c.dot(a);
    const double size = std::max(std::abs(real), std::abs(imaginary));
    // At an edge or vertex the angle is undefined; on a face its sign is uncertain.
    if (!(size > part_error) || (real < 0 && std::abs(imaginary) <= part_error)) {
      error += 1;
      continue;
    }
    const double inverse = 1 / size;
    error += part_error * inverse;
    turns.add(real * inverse, imaginary * inverse);
    if (++until_rescaled % 256 == 0) turns.rescale();
  }
  return {turns.total(), error};
}

BoundedWindingNumber SolidAngleWinding::operator()(const Vec3& point) const {
  std::vector<Vec3> directions;
  return sum(point, directions);
}

std::vector<BoundedWindingNumber> SolidAngleWinding::operator()(
    std::span<const Vec3> points) const {
  std::vector<BoundedWindingNumber> windings(points.size());
  parallel_for(points.size(), points_per_task, [&](std::size_t first, std::size_t last) {
    std::vector<Vec3> directions;
    for (std::size_t i = first; i < last; ++i) windings[i] = sum(points[i], directions);
  });
  return windings;
}

}  // namespace transformesh
