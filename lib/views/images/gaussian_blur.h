/// Gaussian filter of a gray image.
#pragma once

#include "transformesh/image.h"

namespace transformesh {

/// Returns the image filtered by a Gaussian with this `deviation` in pixels, > 0, that is cut off
/// at four deviations. Beyond its border the image continues mirrored. O(pixels * deviation); the
/// same bytes on every machine.
GrayImage gaussian_blur(const GrayImage& image, double deviation);

}  // namespace transformesh
