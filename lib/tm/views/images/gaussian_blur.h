/// Images without their finest detail.
#pragma once

#include "tm/views/images/gray_image.h"

namespace transformesh {

/// The image under a Gaussian of this `deviation` in pixels, > 0, that is cut off at four
/// deviations. Beyond the outermost pixels the image goes on mirrored at them. O(pixels *
/// deviation); the same bytes on every machine.
GrayImage gaussian_blur(const GrayImage& image, double deviation);

}  // namespace transformesh
