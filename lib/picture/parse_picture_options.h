/// Parses sizes, angles and colors of pictures as they are written on a command line. Each function
/// throws UsageError with the text and an example if it cannot be read. Independent of the locale.
#pragma once

#include <string_view>
#include <utility>

#include "picture/linear_color.h"

namespace transformesh {

/// Parses width and height in pixels, each at least 1, such as `800x600`.
std::pair<int, int> parse_size(std::string_view text);

/// Parses azimuth and elevation in degrees, such as `30,20`.
std::pair<double, double> parse_orbit(std::string_view text);

/// Parses a color: `#rrggbb`, `#rgb`, white, black or gray.
Color parse_color(std::string_view text);

/// Parses `transparent`, one color, or the colors at top and bottom, such as `white,#8899aa`.
Background parse_background(std::string_view text);

}  // namespace transformesh
