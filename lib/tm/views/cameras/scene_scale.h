/// Where the cameras look, and how large a pixel is there.
#pragma once

#include <span>

#include "tm/views/cameras/pinhole_camera.h"

namespace transformesh {

/// The point nearest to all viewing axes, in the sense of least squares; where that leaves it open
/// (one camera, parallel axes), the nearest such point to the mean of the cameras' centers.
Vec3 viewed_point(std::span<const PinholeCamera> cameras);

/// The length of a pixel's side at the point, in input units: depth by focal length, the median
/// over the cameras that have the point in front of them. Throws InputError where none has.
double pixel_size(std::span<const PinholeCamera> cameras, const Vec3& point);

}  // namespace transformesh
