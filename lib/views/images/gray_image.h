/// A gray image: one float a pixel, pixel centers at integers. Photographs hold the intensities of
/// their file, 0 to 255, without gamma; silhouettes hold 0 outside and 255 inside, and intensities
/// between along soft edges (contour_distance.h).
#pragma once

#include "picture/image.h"

namespace transformesh {

using GrayImage = Raster<float>;

/// The image under a Gaussian of this `deviation` in pixels, > 0, that is cut off at four
/// deviations. Beyond the outermost pixels the image goes on mirrored at them. O(pixels *
/// deviation); the same bytes on every machine.
GrayImage gaussian_blur(const GrayImage& image, double deviation);

}  // namespace transformesh
