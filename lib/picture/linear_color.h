/// Colors as linear red, green and blue, where 1 is white. Files and screens use sRGB.
/// Reference for the curve: IEC 61966-2-1.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "transformesh/image.h"

namespace transformesh {

using Color = Eigen::Vector3f;

/// Convert an sRGB channel in [0, 1] to linear light, and back. Values outside are clamped.
float light_of_srgb(double channel);
double srgb_of_light(float light);

Color color_of_srgb(double red, double green, double blue);
/// Returns the nearest sRGB value from 0 to 255.
std::uint8_t srgb_byte(float light);
Pixel pixel_of(const Color& color, std::uint8_t alpha = 255);

/// Background of a picture: a linear gradient from the top row to the bottom row.
struct Background {
  // Light gray, #f7f7f7 to #d6d9de.
  Color top = color_of_srgb(0xf7 / 255.0, 0xf7 / 255.0, 0xf7 / 255.0);
  Color bottom = color_of_srgb(0xd6 / 255.0, 0xd9 / 255.0, 0xde / 255.0);
  bool is_transparent = false;

  Color at(int y, int height) const {
    const float share = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
    return top + share * (bottom - top);
  }
};

}  // namespace transformesh
