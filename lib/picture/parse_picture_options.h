/// Parses sizes, angles and colors of pictures as they are written on a command line. Each function
/// throws UsageError with the text and an example if it cannot be read. Independent of the locale.
#pragma once

#include <string_view>
#include <utility>

#include "picture/linear_color.h"

namespace transformesh {

/// `800x600`: width and height, at least 1.
std::pair<int, int> parse_size(std::string_view text);

/// `30,20`: azimuth and elevation in degrees.
std::pair<double, double> parse_orbit(std::string_view text);

/// `#rrggbb` or `#rgb`, or one of white, black, gray.
Color parse_color(std::string_view text);

/// `transparent`, a color, or two from top to bottom: `white,#8899aa`.
Background parse_background(std::string_view text);

}  // namespace transformesh
