#include "views/images/mask.h"

#include <algorithm>
#include <set>

namespace transformesh {
namespace {

// Limits, chosen by hand. They distinguish masks with noisy black and white from label images, and
// from photographs whose background was replaced by black.
/// Least difference between the darkest and the brightest intensity; that of label images is
/// usually smaller.
constexpr float least_range = 64;
/// Black counts as noisy if there are at least this number of dark intensities.
constexpr std::size_t few_dark_intensities = 3;
/// Largest fraction of gray pixels among pixels that are not dark.
constexpr double most_between = 0.2;

bool varies(const GrayImage& image) {
  return std::any_of(image.pixels.begin(), image.pixels.end(),
                     [&](float intensity) { return intensity != image.pixels.front(); });
}

bool has_two_noisy_intensities(const GrayImage& intensities, float darkest, float brightest) {
  const float range = brightest - darkest;
  if (range < least_range) return false;
  std::set<float> dark_intensities;
  std::size_t bright = 0;
  std::size_t between = 0;
  for (const float intensity : intensities.pixels) {
    if (intensity > brightest - range / 4) {
      ++bright;
    } else if (intensity > darkest + range / 4) {
      ++between;
    } else if (intensity > 0 && dark_intensities.size() < few_dark_intensities) {
      dark_intensities.insert(intensity);
    }
  }
  const bool is_black_noisy = darkest > 0 || dark_intensities.size() == few_dark_intensities;
  return is_black_noisy &&
         static_cast<double>(between) <= most_between * static_cast<double>(bright + between);
}

void divide(GrayImage& image, float intensity) {
  for (float& pixel : image.pixels) pixel = pixel > intensity ? 255.0F : 0.0F;
}

}  // namespace

Mask mask_of(GrayImage intensities, const GrayImage& alpha) {
  if (varies(alpha)) {
    Mask mask{alpha, MaskRule::alpha};
    divide(mask.silhouette, 127);
    return mask;
  }
  Mask mask{std::move(intensities), MaskRule::not_black};
  std::vector<float>& pixels = mask.silhouette.pixels;
  const auto [darkest, brightest] = std::minmax_element(pixels.begin(), pixels.end());
  float intensity = 0;
  if (has_two_noisy_intensities(mask.silhouette, *darkest, *brightest)) {
    mask.rule = MaskRule::between_intensities;
    intensity = (*darkest + *brightest) / 2;
  }
  divide(mask.silhouette, intensity);
  return mask;
}

}  // namespace transformesh
