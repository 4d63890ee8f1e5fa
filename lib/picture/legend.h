/// The legend of a picture whose colors stand for numbers: a strip at its bottom with a bar of the
/// colors between the numbers at its ends, in a font of its own.
#pragma once

#include "picture/colormap.h"
#include "picture/linear_color.h"
#include "transformesh/image.h"

namespace transformesh {

/// Pixels of height that the strip takes: a 20th of the shorter side, at least 15; 0 where the
/// picture is too small for a legend (below 120 x 60 pixels).
int legend_height(int width, int height);

/// Fills the bottom rows, as many as legend_height() says, behind them the background's bottom
/// color, or nothing where it is transparent. Numbers have 4 significant digits. Deterministic.
void draw_legend(const ColorScale& scale, const Background& background, Image& image);

}  // namespace transformesh
