#include "views/images/mask.h"

#include <algorithm>
#include <set>

namespace transformesh {
namespace {

/// Fewer levels than this between dark and bright are labels.
constexpr float least_range = 64;
constexpr std::size_t few_dark_levels = 3;
constexpr double most_between = 0.2;

bool varies(const GrayImage& image) {
  return std::any_of(image.pixels.begin(), image.pixels.end(),
                     [&](float level) { return level != image.pixels.front(); });
}

bool is_of_two_noisy_levels(const GrayImage& levels, float darkest, float brightest) {
  const float range = brightest - darkest;
  if (range < least_range) return false;
  std::set<float> dark_levels;
  std::size_t bright = 0;
  std::size_t between = 0;
  for (const float level : levels.pixels) {
    if (level > brightest - range / 4) {
      ++bright;
    } else if (level > darkest + range / 4) {
      ++between;
    } else if (level > 0 && dark_levels.size() < few_dark_levels) {
      dark_levels.insert(level);
    }
  }
  const bool is_black_noisy = darkest > 0 || dark_levels.size() == few_dark_levels;
  return is_black_noisy &&
         static_cast<double>(between) <= most_between * static_cast<double>(bright + between);
}

void divide(GrayImage& image, float level) {
  for (float& pixel : image.pixels) pixel = pixel > level ? 255.0F : 0.0F;
}

}  // namespace

Mask mask_of(GrayImage levels, const GrayImage& alpha) {
  if (varies(alpha)) {
    Mask mask{alpha, MaskRule::alpha};
    divide(mask.silhouette, 127);
    return mask;
  }
  Mask mask{std::move(levels), MaskRule::not_black};
  std::vector<float>& pixels = mask.silhouette.pixels;
  const auto [darkest, brightest] = std::minmax_element(pixels.begin(), pixels.end());
  float level = 0;
  if (is_of_two_noisy_levels(mask.silhouette, *darkest, *brightest)) {
    mask.rule = MaskRule::between_levels;
    level = (*darkest + *brightest) / 2;
  }
  divide(mask.silhouette, level);
  return mask;
}

}  // namespace transformesh
