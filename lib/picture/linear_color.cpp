#include "picture/linear_color.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/elementary/exponential.h"

namespace transformesh {
namespace {

constexpr int steps = 4096;  ///< entries of the table of srgb_byte()

/// Tabulates the sRGB curve by the square root of linear light, at equidistant steps. In terms of
/// the square root the curve is nearly linear.
std::array<float, steps + 1> make_bytes() {
  std::array<float, steps + 1> bytes{};
  for (int i = 0; i <= steps; ++i) {
    const float root = static_cast<float>(i) / steps;
    bytes[static_cast<std::size_t>(i)] = static_cast<float>(255 * srgb_of_light(root * root));
  }
  return bytes;
}

}  // namespace

float light_of_srgb(double channel) {
  channel = std::clamp(channel, 0.0, 1.0);
  return static_cast<float>(channel <= 0.04045 ? channel / 12.92
                                               : elementary::pow((channel + 0.055) / 1.055, 2.4));
}

double srgb_of_light(float light) {
  const double value = std::clamp(static_cast<double>(light), 0.0, 1.0);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * elementary::pow(value, 1 / 2.4) - 0.055;
}

Color color_of_srgb(double red, double green, double blue) {
  return {light_of_srgb(red), light_of_srgb(green), light_of_srgb(blue)};
}

std::uint8_t srgb_byte(float light) {
  static const std::array<float, steps + 1> bytes = make_bytes();
  const float place = std::sqrt(std::clamp(light, 0.0F, 1.0F)) * steps;
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): nothing here is negative
  return static_cast<std::uint8_t>(bytes[static_cast<std::size_t>(place + 0.5F)] + 0.5F);
}

Pixel pixel_of(const Color& color, std::uint8_t alpha) {
  return {srgb_byte(color[0]), srgb_byte(color[1]), srgb_byte(color[2]), alpha};
}

}  // namespace transformesh
