#include "picture/legend.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "support/number.h"

namespace transformesh {
namespace {

// The unit of these lengths is a dot of the font, which is a square of pixels.
constexpr int glyph_rows = 7;               ///< height of a character
constexpr int glyph_columns = 5;            ///< width of a character
constexpr int advance = glyph_columns + 1;  ///< distance between the starts of two characters
constexpr int margin = 4;  ///< space above and below text; twice this space is beside the bar
constexpr int strip_rows = glyph_rows + 2 * margin;  ///< height of the legend
constexpr int least_width = 120;     ///< pixels; chosen by hand: a smaller picture gets no legend
constexpr int least_height = 60;     ///< pixels; chosen by hand: a smaller picture gets no legend
constexpr int pixels_per_dot = 300;  ///< pixels of the shorter image side per dot of the font

struct Glyph {
  char character;
  std::array<std::string_view, glyph_rows> rows;
};

/// All characters in numbers.
constexpr std::array<Glyph, 14> font{{
    {'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    {'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    {'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}},
    {'3', {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}},
    {'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    {'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    {'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    {'7', {"#####", "    #", "   # ", "  #  ", "  #  ", "  #  ", "  #  "}},
    {'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    {'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "}},
    {'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    {'-', {"     ", "     ", "     ", " ### ", "     ", "     ", "     "}},
    {'+', {"     ", "     ", "  #  ", " ### ", "  #  ", "     ", "     "}},
    {'e', {"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### "}},
}};

int dot_size(int width, int height) {
  return std::max(1, std::min(width, height) / pixels_per_dot);
}

void fill(Image& image, int x, int y, int width, int height, const Pixel& pixel) {
  for (int j = y; j < y + height; ++j) std::fill(image.row(j) + x, image.row(j) + x + width, pixel);
}

void draw_text(std::string_view text, int x, int y, int dot, const Pixel& ink, Image& image) {
  for (const char character : text) {
    const auto* glyph = std::ranges::find(font, character, &Glyph::character);
    for (int j = 0; glyph != font.end() && j < glyph_rows; ++j)
      for (int i = 0; i < glyph_columns; ++i)
        if (glyph->rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] == '#')
          fill(image, x + i * dot, y + j * dot, dot, dot, ink);
    x += advance * dot;
  }
}

/// Returns dark ink on light backgrounds, and light ink on dark ones. Transparent backgrounds count
/// as light.
Pixel ink_on(const Background& background) {
  const float brightness = background.bottom.dot(Color(0.2126F, 0.7152F, 0.0722F));
  const bool is_dark = !background.is_transparent && brightness < 0.18F;
  return pixel_of(is_dark ? Color(Color::Constant(0.9F)) : Color(Color::Constant(0.01F)));
}

}  // namespace

int legend_height(int width, int height) {
  if (width < least_width || height < least_height) return 0;
  return strip_rows * dot_size(width, height);
}

void draw_legend(const ColorScale& scale, const Background& background, Image& image) {
  const int rows = legend_height(image.width, image.height);
  if (rows == 0) return;
  const int dot = dot_size(image.width, image.height);
  const int top = image.height - rows;
  const Pixel behind = background.is_transparent ? Pixel{0, 0, 0, 0} : pixel_of(background.bottom);
  fill(image, 0, top, image.width, rows, behind);

  // The bar is half as wide as the picture, or narrower if the numbers need the space.
  constexpr int digits = 4;  // significant digits of the numbers
  const std::string low = significant(scale.low, digits);
  const std::string high = significant(scale.high, digits);
  const int room = advance * dot * static_cast<int>(std::max(low.size(), high.size()));
  const int gap = 2 * margin * dot;
  const int length = std::max(std::min(image.width / 2, image.width - 2 * (room + gap)), 1);
  const int left = (image.width - length) / 2;
  const int text_top = top + margin * dot;
  const Pixel ink = ink_on(background);
  const int low_width = advance * dot * static_cast<int>(low.size());
  draw_text(low, std::max(left - gap / 2 - low_width, 0), text_top, dot, ink, image);
  draw_text(high, left + length + gap / 2, text_top, dot, ink, image);

  // Draw the bar, from the low end to the high end of the scale.
  for (int i = 0; i < length; ++i) {
    const double share = length > 1 ? static_cast<double>(i) / (length - 1) : 0;
    const double value = (1 - share) * scale.low + share * scale.high;
    fill(image, left + i, text_top, 1, glyph_rows * dot, pixel_of(scale.at(value)));
  }
}

}  // namespace transformesh
