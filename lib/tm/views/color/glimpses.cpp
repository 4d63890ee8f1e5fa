#include "tm/views/color/glimpses.h"

#include <algorithm>
#include <limits>

namespace transformesh {
namespace {

/// Of the best quality: views that are as good as this have a vote.
constexpr float voting_share = 0.6F;
/// Gray levels by which views differ that see the same.
constexpr float usual_difference = 24;

Eigen::Array3f levels_of(const Glimpse& glimpse) {
  return {static_cast<float>(glimpse.color[0]), static_cast<float>(glimpse.color[1]),
          static_cast<float>(glimpse.color[2])};
}

// Of the first ones; the others are larger than any level.
float median_of(std::array<float, 4> values, std::size_t count) {
  std::sort(values.begin(), values.end());
  return (values[(count - 1) / 2] + values[count / 2]) / 2;
}

float power_16(float value) {
  for (int i = 0; i < 4; ++i) value *= value;
  return value;
}

}  // namespace

void Glimpses::add(const Glimpse& glimpse) {
  if (!(glimpse.quality > best_.back().quality)) return;
  std::size_t place = best_.size() - 1;
  for (; place > 0 && glimpse.quality > best_[place - 1].quality; --place)
    best_[place] = best_[place - 1];
  best_[place] = glimpse;
}

std::size_t Glimpses::count_as_good(float share) const {
  const auto end = std::find_if(best_.begin(), best_.end(), [&](const Glimpse& glimpse) {
    return glimpse.quality == 0 || glimpse.quality < share * best_[0].quality;
  });
  return static_cast<std::size_t>(end - best_.begin());
}

Eigen::Array3f Glimpses::blend() const {
  const std::size_t voters = count_as_good(voting_share);
  Eigen::Array3f median;
  for (int channel = 0; channel < 3; ++channel) {
    std::array<float, 4> values;
    values.fill(std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < voters; ++i) values[i] = levels_of(best_[i])[channel];
    median[channel] = median_of(values, voters);
  }

  Eigen::Array3f sum = Eigen::Array3f::Zero();
  float weights = 0;
  for (const Glimpse& glimpse : best_) {
    if (glimpse.quality == 0) break;
    float weight = power_16(glimpse.quality / best_[0].quality);
    const Eigen::Array3f levels = levels_of(glimpse);
    if (voters >= 3) {
      const float off = (levels - median).abs().maxCoeff() / usual_difference;
      weight /= 1 + power_16(off);
    }
    sum += weight * levels;
    weights += weight;
  }
  return weights > 0 ? Eigen::Array3f(sum / weights) : median;
}

float Glimpses::difference(const Eigen::Array3f& color) const {
  const std::size_t count = count_as_good(voting_share);
  float sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += (levels_of(best_[i]) - color).abs().mean();
  return count > 0 ? sum / static_cast<float>(count) : 0;
}

}  // namespace transformesh
