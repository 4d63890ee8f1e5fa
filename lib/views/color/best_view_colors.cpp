#include "views/color/best_view_colors.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace transformesh {
namespace {

/// A view counts as good for a surface point if its quality is at least this fraction of the
/// point's best quality. Good views determine the median color of the point.
constexpr float voting_share = 0.6F;
/// Typical difference between the intensities of a surface point in two views, from 0 to 255.
/// Colors that differ much more from the median lose their weight. If the value is larger, fewer
/// highlights are suppressed; if it is smaller, correct views are suppressed as well.
constexpr float usual_difference = 24;

/// Qualities are stored in 16 bits: the leading bits of floats from 2^-16 to 2^16, with eleven bits
/// of the mantissa.
constexpr float least_quality = 0x1p-16F;
constexpr float largest_quality = 0x1.ffp15F;
constexpr int bits_left_out = 12;

std::uint16_t coded(float quality) {
  const float kept = std::clamp(quality, least_quality, largest_quality);
  const std::uint32_t above =
      std::bit_cast<std::uint32_t>(kept) - std::bit_cast<std::uint32_t>(least_quality);
  return static_cast<std::uint16_t>((above >> bits_left_out) + 1);
}

float quality_of(std::uint16_t code) {
  if (code == 0) return 0;
  const std::uint32_t above = (std::uint32_t{code} - 1) << bits_left_out;
  return std::bit_cast<float>(above + std::bit_cast<std::uint32_t>(least_quality));
}

// Returns the median of the first `count` values. The caller must set the remaining values to
// larger numbers, so that they are sorted to the end.
float median_of(std::array<float, 4> values, std::size_t count) {
  std::sort(values.begin(), values.end());
  return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

float power_16(float value) {
  for (int i = 0; i < 4; ++i) value *= value;
  return value;
}

}  // namespace

void BestViewColors::add(const ViewColor& color, std::size_t view) {
  if (!(color.quality > 0)) return;
  constexpr std::size_t last_view = std::numeric_limits<std::uint16_t>::max();
  const Held held{coded(color.quality), static_cast<std::uint16_t>(std::min(view, last_view)),
                  color.color};
  if (held.quality <= best_.back().quality) return;
  std::size_t place = best_.size() - 1;
  for (; place > 0 && held.quality > best_[place - 1].quality; --place)
    best_[place] = best_[place - 1];
  best_[place] = held;
}

float BestViewColors::share(std::size_t i) const {
  return quality_of(best_[i].quality) / quality_of(best_[0].quality);
}

std::size_t BestViewColors::count_good() const {
  std::size_t count = 0;
  while (count < best_.size() && best_[count].quality > 0 && share(count) >= voting_share) ++count;
  return count;
}

Eigen::Array3f BestViewColors::intensities(std::size_t i) const {
  const auto& color = best_[i].color;
  return {static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2])};
}

Eigen::Array3f BestViewColors::blend(std::span<const Gain> gains) const {
  const std::size_t voters = count_good();
  Eigen::Array3f median;
  for (int channel = 0; channel < 3; ++channel) {
    std::array<float, 4> values;
    values.fill(std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < voters; ++i) values[i] = evened(i, gains)[channel];
    median[channel] = median_of(values, voters);
  }

  Eigen::Array3f sum = Eigen::Array3f::Zero();
  float weights = 0;
  for (std::size_t i = 0; i < best_.size() && best_[i].quality > 0; ++i) {
    float weight = power_16(share(i));
    const Eigen::Array3f color = evened(i, gains);
    if (voters >= 3) {
      const float off = (color - median).abs().maxCoeff() / usual_difference;
      weight /= 1 + power_16(off);
    }
    sum += weight * color;
    weights += weight;
  }
  const Eigen::Array3f color = weights > 0 ? Eigen::Array3f(sum / weights) : median;
  return color.min(255.0F);
}

float BestViewColors::difference(const Eigen::Array3f& color, std::span<const Gain> gains) const {
  const std::size_t count = count_good();
  float sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += (evened(i, gains) - color).abs().mean();
  return count > 0 ? sum / static_cast<float>(count) : 0;
}

}  // namespace transformesh
