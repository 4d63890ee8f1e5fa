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
  PackableImage silhouette;  ///< empty if unknown; otherwise has the size of the image
};

std::vector<PinholeCamera> cameras_of(std::span<const View> views);

/// Shrinks an image by the factor `scale`, for coarse-to-fine reconstruction. Each pixel of the
/// result is the mean over its area in `image` after a Gaussian blur. The blur removes detail that
/// is finer than the pixels of the result. Its standard deviation is 0.45 `scale`, in pixels of
/// `image`. At scale 1 it is 0.6, which only reduces noise. Outside of the image, border pixels are
/// repeated. Pixels on the right and at the bottom of `image` that do not fill a whole pixel of the
/// result are dropped. Throws UsageError if `scale` is below 1 or no pixel would be left.
/// O(pixels); deterministic.
GrayImage at_scale(const GrayImage& image, double scale);

/// Shrinks image, silhouette and camera. The camera becomes PinholeCamera::shrunk(), so that rays
/// through the corners of the image do not change. At scale 1 the silhouette does not change.
View at_scale(const View& view, double scale);

/// Returns the part of a view in a rectangle of pixels, with the camera of that part. The rectangle
/// must be inside of the image.
View cropped(const View& view, int column, int row, int columns, int rows);

}  // namespace transformesh
