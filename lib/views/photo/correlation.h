/// Windowed normalized cross-correlation of two images under a mask, and its exact derivative with
/// respect to the second image.
/// Reference: Pons, Keriven & Faugeras, "Multi-view stereo reconstruction and scene flow estimation
/// with a global image-based matching score", IJCV 72(2), 2007.
///
/// Sums run over the visible pixels of a square window. Then cc = v12 / sqrt(v1 v2), where the
/// variance of the noise is added to the variances v1 and v2. The weight of a window is rho =
/// min(v1, v2) / (min(v1, v2) + contrast). The energy is the sum of rho (1 - cc) over all visible
/// pixels of whose window more than half is visible. Its derivative treats rho as constant. The
/// derivative by an intensity of the second image sums over all windows with that pixel.
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

/// One row of both images, which the caller fills. Values are 0 at pixels that are not visible.
struct ComparedRow {
  float* is_seen = nullptr;
  float* first = nullptr;
  float* second = nullptr;
  float* slope = nullptr;  ///< derivative of `second` with respect to the coordinate of interest
};

/// Derivatives of the loss with respect to the coordinate of interest of each point.
struct CorrelationRow {
  const float* is_seen = nullptr;
  const float* gradient = nullptr;  ///< first derivative
  /// Half of the Gauss-Newton approximation of the second derivative; >= 0.
  const float* curvature = nullptr;
};

/// Windows around the pixels of one row.
struct WindowRow {
  const float* weight = nullptr;      ///< rho; 0 for windows that are not compared
  const float* energy = nullptr;      ///< rho (1 - cc)
  const float* deviations = nullptr;  ///< sqrt(v1 v2)
};

struct CorrelationSums {
  double energy = 0;       ///< sum of rho (1 - cc), whether robust or not
  double loss = 0;         ///< the sum that is differentiated; equals `energy` if not robust
  double weight = 0;       ///< sum of rho
  std::size_t pixels = 0;  ///< number of compared windows
};

/// Compares the rows from `first_row` to `end_row` - 1. Calls `fill` for each row in this order.
/// Calls `look` with the windows of a row, and later `take` with its derivatives, both in the same
/// order. `take` and `look` may be empty. Throws UsageError if options are out of range.
CorrelationSums correlate(int width, int first_row, int end_row, const CorrelationOptions& options,
                          const std::function<void(int y, const ComparedRow&)>& fill,
                          const std::function<void(int y, const CorrelationRow&)>& take,
                          const std::function<void(int y, const WindowRow&)>& look = {});

}  // namespace transformesh
