/// One calibrated photograph, and the same with fewer pixels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "views/cameras/pinhole_camera.h"
#include "views/images/packable_image.h"

namespace transformesh {

struct View {
  std::string name;  ///< of the image file, without folder and extension
  PinholeCamera camera;
  PackableImage image;
  PackableImage silhouette;  ///< of the image's size, or empty where there is none
};

std::vector<PinholeCamera> cameras_of(std::span<const View> views);

/// The image with fewer pixels, for evolutions from coarse to fine (paper 5.3.1). Every pixel is
/// the mean over its area in the given image, after a Gaussian of deviation 0.45 scale, in pixels
/// of the given image, that keeps finer detail out; of 0.6 at scale 1, where it only tames noise.
/// Beyond the border the outermost pixels continue; at the right and at the bottom, what does not
/// fill a pixel is left out. Throws UsageError for a scale below 1 or so large that no pixel is
/// left. O(pixels); deterministic.
GrayImage at_scale(const GrayImage& image, double scale);

/// Image, silhouette (which keeps its intensities at scale 1), and the camera of the smaller image:
/// PinholeCamera::shrunk, so that the corners of the image stay where they are.
View at_scale(const View& view, double scale);

/// The part of a view that begins at (column, row), which must be inside, with its camera.
View cropped(const View& view, int column, int row, int columns, int rows);

}  // namespace transformesh
