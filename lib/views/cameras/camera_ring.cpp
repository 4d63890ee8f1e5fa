#include "views/cameras/camera_ring.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/elementary/arctangent.h"
#include "support/elementary/trigonometric.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Fraction of the image's shorter side that the bounding ball of the object fills; documented for
/// distance_for().
constexpr double filled_share = 0.88;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

void check_ring(const CameraRing& ring) {
  if (ring.count < 1 || ring.elevations_deg.empty())
    throw UsageError("a ring needs at least one camera and one elevation");
  for (const double elevation : ring.elevations_deg)
    if (!(std::abs(elevation) < 90)) throw UsageError("an elevation must be within 90 degrees");
  if (!(ring.distance > 0 && ring.focal_length > 0))
    throw UsageError("the distance and the focal length of a ring must be above 0");
  if (ring.width < 1 || ring.height < 1) throw UsageError("images need at least one pixel");
}

PinholeCamera camera_towards(const CameraRing& ring, double azimuth, double elevation) {
  const Vec3 back(elementary::cos(elevation) * elementary::cos(azimuth),
                  elementary::cos(elevation) * elementary::sin(azimuth),
                  elementary::sin(elevation));
  PinholeCamera camera;
  camera.intrinsics << ring.focal_length, 0, (ring.width - 1) / 2.0, 0, ring.focal_length,
      (ring.height - 1) / 2.0, 0, 0, 1;
  const Vec3 right(-elementary::sin(azimuth), elementary::cos(azimuth), 0);
  camera.rotation.row(0) = right;
  camera.rotation.row(1) = right.cross(back);  // downwards
  camera.rotation.row(2) = -back;
  camera.translation = -(camera.rotation * (ring.center + ring.distance * back));
  return camera;
}

std::string ring_view_name(int index) {
  const std::string number = std::to_string(index);
  return "view" + std::string(number.size() < 4 ? 4 - number.size() : 0, '0') + number;
}

}  // namespace

double distance_for(std::span<const Vec3> points, const CameraRing& ring) {
  double radius = 0;
  for (const Vec3& point : points) radius = std::max(radius, (point - ring.center).norm());
  const double half_side = filled_share * std::min(ring.width, ring.height) / 2;
  return radius / elementary::sin(elementary::atan(half_side / ring.focal_length));
}

CameraList camera_ring(const CameraRing& ring) {
  check_ring(ring);
  CameraList list;
  list.names_images = true;
  for (int i = 0; i < ring.count; ++i) {
    const auto turn = static_cast<std::size_t>(i) % ring.elevations_deg.size();
    CameraRecord record;
    record.name = ring_view_name(i);
    record.camera = camera_towards(ring, 2 * std::numbers::pi * i / ring.count,
                                   radians(ring.elevations_deg[turn]));
    record.width = ring.width;
    record.height = ring.height;
    list.cameras.push_back(std::move(record));
  }
  return list;
}

}  // namespace transformesh
