#include "picture/parse_picture_options.h"

#include <cmath>
#include <optional>
#include <string>

#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Splits the text at the first separator. The second part is empty if there is none.
std::pair<std::string_view, std::string_view> halves(std::string_view text, char separator) {
  const std::size_t place = text.find(separator);
  if (place == std::string_view::npos) return {text, {}};
  return {text.substr(0, place), text.substr(place + 1)};
}

[[noreturn]] void refuse(std::string_view text, const std::string& what) {
  throw UsageError("'" + std::string(text) + "' is not " + what);
}

/// Reads three or six hexadecimal digits.
std::optional<Color> color_of_digits(std::string_view digits) {
  const auto number = number_in<unsigned>(digits, 16);
  if (!number || (digits.size() != 3 && digits.size() != 6)) return std::nullopt;
  const unsigned bits = digits.size() == 6 ? 8 : 4;
  const unsigned full = (1U << bits) - 1;
  const auto channel = [&](unsigned place) {
    return static_cast<double>(*number >> place * bits & full) / full;
  };
  return color_of_srgb(channel(2), channel(1), channel(0));
}

}  // namespace

std::pair<int, int> parse_size(std::string_view text) {
  const auto [left, right] = halves(text, 'x');
  const auto width = number_in<int>(left);
  const auto height = number_in<int>(right);
  if (!width || !height || *width < 1 || *height < 1)
    refuse(text, "a size in pixels: write it as 800x600");
  return {*width, *height};
}

std::pair<double, double> parse_orbit(std::string_view text) {
  const auto [left, right] = halves(text, ',');
  const auto azimuth = number_in<double>(left);
  const auto elevation = number_in<double>(right);
  if (!azimuth || !elevation || !std::isfinite(*azimuth) || !std::isfinite(*elevation))
    refuse(text, "a pair of angles in degrees: write azimuth,elevation as 30,20");
  return {*azimuth, *elevation};
}

Color parse_color(std::string_view text) {
  if (text == "white") return Color::Ones();
  if (text == "black") return Color::Zero();
  if (text == "gray" || text == "grey") return color_of_srgb(0.5, 0.5, 0.5);
  const auto color = text.starts_with('#') ? color_of_digits(text.substr(1)) : std::nullopt;
  if (!color) refuse(text, "a color: write it as #rrggbb, or white, black or gray");
  return *color;
}

Background parse_background(std::string_view text) {
  Background background;
  if (text == "transparent") {
    background.is_transparent = true;
    return background;
  }
  const auto [top, bottom] = halves(text, ',');
  background.top = parse_color(top);
  background.bottom = top.size() == text.size() ? background.top : parse_color(bottom);
  return background;
}

}  // namespace transformesh
