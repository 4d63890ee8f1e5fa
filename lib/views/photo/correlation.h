/// Windowed normalized cross-correlation of two images under a mask, and its exact derivative by
/// the second image, one row after the other.
/// Reference: Pons, Keriven & Faugeras, "Multi-view stereo reconstruction and scene flow estimation
/// with a global image-based matching score", IJCV 72(2), 2007.
///
/// With sums over the seen pixels of a square window: cc = v12 / sqrt(v1 v2), the variances grown
/// by that of the noise; rho = min(v1, v2) / (min(v1, v2) + contrast); the energy is the sum of
/// rho (1 - cc) over all seen pixels whose window is more than half seen. Its derivative by an
/// intensity of the second image takes rho as constant, and sums over all windows with that pixel.
///
/// With `robust` s above 0, what is differentiated is the sum of rho s e / (s + e), e = 1 - cc: the
/// loss of Geman & McClure, "Statistical methods for tomographic image reconstruction", Bulletin of
/// the ISI 52(4), 1987. Windows that disagree pull by (s / (s + e))^2 of what they would. The
/// gradient is exact; the curvature takes these shares as constant, as reweighted least squares do.
/// Intensities are floats, less a middle intensity. O(radius) operations a pixel, all on whole
/// rows.
#pragma once

#include <cstddef>
#include <functional>

namespace transformesh {

struct CorrelationOptions {
  int radius = 3;              ///< of the window, in pixels; 1 to 5
  double noise_variance = 25;  ///< added to the variances, in squared intensities; > 0
  double contrast = 25;        ///< variance at which rho is 1/2; 0: rho is 1
  double robust = 0;  ///< s, 1 - cc at which a window pulls by a quarter; 0.001 to 1000, or
                      ///< 0: the loss is 1 - cc
};

/// A row of both images, to be filled; 0 where nothing is seen.
struct ComparedRow {
  float* is_seen = nullptr;
  float* first = nullptr;
  float* second = nullptr;
  float* slope = nullptr;  ///< derivative of `second` by the coordinate in question
};

/// Derivatives of the energy by the coordinate of each point along which `second` has its slope.
struct CorrelationRow {
  const float* is_seen = nullptr;
  const float* gradient = nullptr;   ///< first derivative
  const float* curvature = nullptr;  ///< second derivative after Gauss and Newton, halved: >= 0
};

/// The windows around the pixels of a row.
struct WindowRow {
  const float* weight = nullptr;      ///< rho, 0 where they are not compared
  const float* energy = nullptr;      ///< rho (1 - cc)
  const float* deviations = nullptr;  ///< sqrt(v1 v2)
};

struct CorrelationSums {
  double energy = 0;       ///< without regard to the loss
  double loss = 0;         ///< the sum that is differentiated: the energy, if not robust
  double weight = 0;       ///< sum of rho
  std::size_t pixels = 0;  ///< windows compared
};

/// Asks `fill` for rows first_row to end_row - 1 in this order, and hands the derivatives of each
/// to `take`, later, in the same order; and the windows, before, to `look`. Either may be empty.
CorrelationSums correlate(int width, int first_row, int end_row, const CorrelationOptions& options,
                          const std::function<void(int y, const ComparedRow&)>& fill,
                          const std::function<void(int y, const CorrelationRow&)>& take,
                          const std::function<void(int y, const WindowRow&)>& look = {});

}  // namespace transformesh
