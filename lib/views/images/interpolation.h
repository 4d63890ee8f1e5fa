/// Interpolation of intensities between pixels, and the derivative of the interpolant.
#pragma once

#include <Eigen/Core>

#include "transformesh/image.h"
#include "transformesh/photo_step.h"

namespace transformesh {

struct Sample {
  float intensity = 0;
  /// Derivative of the interpolated intensity in the direction that the caller gives.
  float slope = 0;
};

/// Number of pixels that interpolation reads to the left of and above a pixel. To the right and
/// below, it reads one pixel more.
template <Interpolation interpolation>
inline constexpr int margin = interpolation == Interpolation::catmull_rom ? 1 : 0;

/// Returns the interpolated intensity at (column + s, row + t), and its derivative in direction
/// (along_x, along_y). `s` and `t` are in [0, 1).
template <Interpolation interpolation>
Sample sample(const GrayImage& image, int column, int row, float s, float t, float along_x,
              float along_y);

template <>
inline Sample sample<Interpolation::bilinear>(const GrayImage& image, int column, int row, float s,
                                              float t, float along_x, float along_y) {
  const float* top = image.row(row) + column;
  const float* bottom = top + image.width;
  const float top_step = top[1] - top[0];
  const float bottom_step = bottom[1] - bottom[0];
  const float top_intensity = top[0] + s * top_step;
  const float down = bottom[0] + s * bottom_step - top_intensity;
  return {top_intensity + t * down,
          along_x * (top_step + t * (bottom_step - top_step)) + along_y * down};
}

/// Weights of four consecutive pixels for the intensity and for its derivative. They are
/// polynomials of the position `t` between the inner two pixels.
/// Reference: Keys, "Cubic convolution interpolation for digital image processing", IEEE TASSP 29
/// (1981), with a = -1/2, also known as Catmull-Rom.
struct CubicWeights {
  Eigen::Array4f intensity;
  Eigen::Array4f slope;

  [[gnu::always_inline]] explicit CubicWeights(float t) {
    const Eigen::Array4f c1(-0.5F, 0, 0.5F, 0);
    const Eigen::Array4f c2(1, -2.5F, 2, -0.5F);
    const Eigen::Array4f c3(-0.5F, 1.5F, -1.5F, 0.5F);
    intensity = Eigen::Array4f(0, 1, 0, 0) + t * (c1 + t * (c2 + t * c3));
    slope = c1 + t * (2 * c2 + 3 * t * c3);
  }
};

template <>
[[gnu::always_inline]] inline Sample sample<Interpolation::catmull_rom>(
    const GrayImage& image, int column, int row, float s, float t, float along_x, float along_y) {
  const CubicWeights across(s);
  const CubicWeights down(t);
  Eigen::Array4f intensity = Eigen::Array4f::Zero();
  Eigen::Array4f slope = Eigen::Array4f::Zero();
  for (int i = 0; i < 4; ++i) {
    const Eigen::Map<const Eigen::Array4f> intensities(image.row(row + i - 1) + column - 1);
    intensity += down.intensity[i] * intensities;
    slope += down.slope[i] * intensities;
  }
  return {(intensity * across.intensity).sum(),
          (along_x * intensity * across.slope + along_y * slope * across.intensity).sum()};
}

}  // namespace transformesh
