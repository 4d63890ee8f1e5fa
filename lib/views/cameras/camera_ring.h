/// Cameras around an object, as on a turntable.
#pragma once

#include <span>
#include <vector>

#include "views/cameras/camera_file.h"

namespace transformesh {

struct CameraRing {
  int count = 16;  ///< >= 1
  std::vector<double> elevations_deg = {
      18, -12};                ///< above the horizon, < 90 either way, taken in turn
  Vec3 center = Vec3::Zero();  ///< the point that all cameras look at
  double distance = 1;         ///< > 0, from the center
  int width = 320;             ///< >= 1, of the images, in pixels
  int height = 240;            ///< >= 1
  double focal_length = 1090;  ///< > 0, in pixels
};

/// The distance from which the smallest ball around the ring's center that holds the points fills
/// most of the image's shorter side.
double distance_for(std::span<const Vec3> points, const CameraRing& ring);

/// Named view0000 and so on, evenly around the z axis from +x on, z upwards in the images. Throws
/// UsageError for options out of range.
CameraList camera_ring(const CameraRing& ring);

}  // namespace transformesh
