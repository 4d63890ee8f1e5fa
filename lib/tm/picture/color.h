/// Colours as light: linear red, green and blue, 1 being white. Files and screens hold sRGB.
/// Reference for the curve: IEC 61966-2-1.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace transformesh {

using Color = Eigen::Vector3f;

/// From an sRGB channel in [0, 1], and back. Values outside are clamped.
float light_of_srgb(double channel);
double srgb_of_light(float light);

Color color_of_srgb(double red, double green, double blue);
/// The nearest of 256 levels.
std::uint8_t srgb_byte(float light);

}  // namespace transformesh
