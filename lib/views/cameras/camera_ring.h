/// Generates cameras on a ring around an object, as on a turntable.
#pragma once

#include <span>
#include <vector>

#include "views/cameras/camera_file.h"

namespace transformesh {

struct CameraRing {
  int count = 16;  ///< number of cameras, >= 1
  std::vector<double> elevations_deg = {
      18, -12};  ///< degrees above the horizon, in (-90, 90); assigned to cameras in turn
  Vec3 center = Vec3::Zero();  ///< the point at which all cameras look
  double distance = 1;         ///< distance of the cameras from the center, > 0
  int width = 320;             ///< width of the images in pixels, >= 1
  int height = 240;            ///< height of the images in pixels, >= 1
  double focal_length = 1090;  ///< focal length in pixels, > 0
};

/// Returns a distance at which the smallest ball around the ring's center that contains all points
/// fills 0.88 of the image's shorter side.
double distance_for(std::span<const Vec3> points, const CameraRing& ring);

/// Returns cameras view0000, view0001, ... at equal angles around the z axis, beginning at +x. The
/// z axis points up in the images. Throws UsageError if options are out of range.
CameraList camera_ring(const CameraRing& ring);

}  // namespace transformesh
