/// A calibrated photograph, and reduction of its resolution.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "transformesh/pinhole_camera.h"
#include "views/images/packable_image.h"

namespace transformesh {

struct View {
  std::string name;  ///< name of the image file, without folder and extension
  PinholeCamera camera;
  PackableImage image;
  PackableImage silhouette;  ///< has the size of the image; empty if unknown
};

std::vector<PinholeCamera> cameras_of(std::span<const View> views);

/// Shrinks an image for evolutions from coarse to fine (paper 5.3.1). Each pixel is the mean over
/// its area in `image` after a Gaussian blur, which removes detail that is too fine. The standard
/// deviation is 0.45 `scale`, in pixels of `image`. At scale 1 it is 0.6, which only reduces noise.
/// Outside of the image, border pixels are repeated. Pixels on the right and at the bottom that do
/// not fill a pixel of the result are dropped. Throws UsageError if `scale` is below 1 or no pixel
/// would be left. O(pixels); deterministic.
GrayImage at_scale(const GrayImage& image, double scale);

/// Shrinks image, silhouette and camera. The camera is PinholeCamera::shrunk(), so that the corners
/// of the image keep their directions. At scale 1 the silhouette does not change.
View at_scale(const View& view, double scale);

/// Returns a rectangle of a view, with its camera. The rectangle must be inside of the view.
View cropped(const View& view, int column, int row, int columns, int rows);

}  // namespace transformesh
