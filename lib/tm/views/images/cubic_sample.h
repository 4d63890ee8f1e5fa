/// Levels between sixteen pixels, by cubic convolution.
/// Reference: Keys, "Cubic convolution interpolation for digital image processing", IEEE TASSP 29
/// (1981), with a = -1/2, also known as Catmull-Rom.
#pragma once

#include <Eigen/Core>

#include "tm/views/images/interpolation.h"

namespace transformesh {

/// Weights of four neighbours as polynomials of the place between the inner two.
struct CubicWeights {
  Eigen::Array4f level;
  Eigen::Array4f slope;

  explicit CubicWeights(float t) {
    const Eigen::Array4f c1(-0.5F, 0, 0.5F, 0);
    const Eigen::Array4f c2(1, -2.5F, 2, -0.5F);
    const Eigen::Array4f c3(-0.5F, 1.5F, -1.5F, 0.5F);
    level = Eigen::Array4f(0, 1, 0, 0) + t * (c1 + t * (c2 + t * c3));
    slope = c1 + t * (2 * c2 + 3 * t * c3);
  }
};

template <>
inline Sample sample<Interpolation::catmull_rom>(const GrayImage& image, int column, int row,
                                                 float s, float t, float along_x, float along_y) {
  const CubicWeights across(s);
  const CubicWeights down(t);
  Eigen::Array4f level = Eigen::Array4f::Zero();
  Eigen::Array4f slope = Eigen::Array4f::Zero();
  for (int i = 0; i < 4; ++i) {
    const Eigen::Map<const Eigen::Array4f> levels(image.row(row + i - 1) + column - 1);
    level += down.level[i] * levels;
    slope += down.slope[i] * levels;
  }
  return {(level * across.level).sum(),
          (along_x * level * across.slope + along_y * slope * across.level).sum()};
}

}  // namespace transformesh
