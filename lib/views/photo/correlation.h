/// Computes the windowed normalized cross-correlation (cc) of two images, in which some pixels are
/// not visible, and its exact derivative with respect to the second image.
/// Reference: Pons, Keriven & Faugeras, "Multi-view stereo reconstruction and scene flow estimation
/// with a global image-based matching score", IJCV 72(2), 2007.
///
/// Let v1, v2 and v12 be the variances and the covariance of both images over the visible pixels of
/// a square window. The variance of the noise is added to v1 and v2. Then cc = v12 / sqrt(v1 v2).
/// The weight of a window is rho = min(v1, v2) / (min(v1, v2) + contrast). The energy is the sum of
/// rho (1 - cc) over all visible pixels whose window is more than half visible. Its derivative
/// treats rho as constant. The derivative with respect to an intensity of the second image is a sum
/// over all windows that contain that pixel.
///
/// Let s be `robust`, and e = 1 - cc. If s > 0, the sum of rho s e / (s + e) is differentiated
/// instead. This is the loss of Geman & McClure, "Statistical methods for tomographic image
/// reconstruction", Bulletin of the ISI 52(4), 1987. This loss scales the derivative of a window by
/// (s / (s + e))^2, so that windows that disagree have less influence. The gradient is exact. The
/// curvature treats these factors as constant, as in iteratively reweighted least squares.
///
/// Images are processed row by row, in single precision, and should have a mean near 0. O(radius)
/// operations per pixel, all on whole rows.
#pragma once

#include <cstddef>
#include <functional>

#include "transformesh/photo_step.h"

namespace transformesh {

/// One row of both images, which the caller of correlate() fills. Values are 0 at pixels that are
/// not visible.
struct ComparedRow {
  float* is_seen = nullptr;
  float* first = nullptr;
  float* second = nullptr;
  /// Derivative of `second` with respect to a coordinate, such as the depth of the point at a
  /// pixel.
  float* slope = nullptr;
};

/// Derivatives of the loss with respect to the coordinate (see ComparedRow::slope) at each pixel of
/// a row.
struct CorrelationRow {
  const float* is_seen = nullptr;
  const float* gradient = nullptr;  ///< first derivative
  /// Half of the Gauss-Newton approximation of the second derivative; >= 0.
  const float* curvature = nullptr;
};

/// Values of the windows around the pixels of one row.
struct WindowRow {
  /// Weight of the window (rho in the file comment); 0 for windows that are not compared.
  const float* weight = nullptr;
  const float* energy = nullptr;  ///< weight times (1 - correlation) of the window
  /// Product of the standard deviations of both images in the window.
  const float* deviations = nullptr;
};

struct CorrelationSums {
  /// Sum over windows of weight times (1 - correlation), also if a robust loss is differentiated.
  double energy = 0;
  /// The sum that is differentiated; equals `energy` if CorrelationOptions::robust is 0.
  double loss = 0;
  double weight = 0;       ///< sum of the weights rho of all windows
  std::size_t pixels = 0;  ///< number of compared windows
};

/// Compares both images in the rows from `first_row` to `end_row` - 1. Three callbacks are called
/// for each row, in ascending order. `fill` provides the pixels of a row. `look` later receives the
/// correlation windows around them, and `take` receives the derivatives. `take` and `look` may be
/// empty. Throws UsageError if options are out of range.
CorrelationSums correlate(int width, int first_row, int end_row, const CorrelationOptions& options,
                          const std::function<void(int y, const ComparedRow&)>& fill,
                          const std::function<void(int y, const CorrelationRow&)>& take,
                          const std::function<void(int y, const WindowRow&)>& look = {});

}  // namespace transformesh
