/// Draws the legend of a picture whose colors represent numbers. The legend is a strip at the
/// bottom with a color bar and the numbers at its ends, in a built-in font.
#pragma once

#include "picture/colormap.h"
#include "picture/linear_color.h"
#include "transformesh/image.h"

namespace transformesh {

/// Returns the height of the strip in pixels: a 20th of the shorter side, at least 15. Returns 0 if
/// the picture is smaller than 120 x 60 pixels.
int legend_height(int width, int height);

/// Draws the legend into the bottom legend_height() rows. The background is its bottom color, or
/// transparent. Numbers have 4 significant digits. Deterministic.
void draw_legend(const ColorScale& scale, const Background& background, Image& image);

}  // namespace transformesh
