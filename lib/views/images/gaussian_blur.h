/// Gaussian filter of a gray image.
#pragma once

#include "transformesh/image.h"

namespace transformesh {

/// Returns the image filtered by a Gaussian with standard deviation `deviation` in pixels, > 0,
/// truncated at four deviations. The image is mirrored at its border. O(pixels * deviation). The
/// result is the same on every machine, bit by bit.
GrayImage gaussian_blur(const GrayImage& image, double deviation);

}  // namespace transformesh
