#include "tm/views/images/held_image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace transformesh {
namespace {

constexpr float levels_per_unit = 256;
constexpr float distances_per_unit = 64;
constexpr float no_distance = 32768;  ///< the word that is distance 0
constexpr std::uint16_t last_word = 65535;
constexpr float infinity = std::numeric_limits<float>::infinity();

std::uint16_t word_of(float value) {
  return static_cast<std::uint16_t>(std::clamp(value + 0.5F, 0.0F, 65535.0F));
}

/// The first and the last word stand for what is infinite.
std::uint16_t word_of_distance(float distance) {
  if (std::isinf(distance)) return distance < 0 ? 0 : last_word;
  return word_of(std::clamp(no_distance + distances_per_unit * distance, 1.0F, 65534.0F));
}

bool is_byte(float level) { return level >= 0 && level <= 255 && level == std::floor(level); }

}  // namespace

std::size_t HeldImage::size() const {
  return sizeof(float) * floats_.pixels.size() + bytes_.size() + 2 * words_.size();
}

void HeldImage::pack(Kind kind) {
  if (is_packed() || empty()) return;
  kind_ = kind;
  const std::vector<float> pixels = std::exchange(floats_, GrayImage()).pixels;
  if (kind == Kind::levels && std::all_of(pixels.begin(), pixels.end(), is_byte)) {
    bytes_.assign(pixels.begin(), pixels.end());
    return;
  }
  if (kind == Kind::depths) {
    float nearest = infinity;
    float farthest = 0;
    for (const float depth : pixels) {
      if (depth == 0) continue;
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
    offset_ = farthest > 0 ? nearest : 0;
    step_ = (farthest - offset_) / (last_word - 1);
  }
  words_.resize(pixels.size());
  std::transform(pixels.begin(), pixels.end(), words_.begin(), [&](float value) -> std::uint16_t {
    if (kind == Kind::levels) return word_of(levels_per_unit * value);
    if (kind == Kind::distances) return word_of_distance(value);
    if (value == 0) return 0;
    if (!(step_ > 0)) return 1;
    return static_cast<std::uint16_t>(
        1 + std::clamp(std::ceil((value - offset_) / step_), 0.0F, 65534.0F));
  });
}

float HeldImage::value_of(std::uint16_t word) const {
  switch (kind_) {
    case Kind::levels:
      return static_cast<float>(word) / levels_per_unit;
    case Kind::distances:
      if (word == 0 || word == last_word) return word == 0 ? -infinity : infinity;
      return (static_cast<float>(word) - no_distance) / distances_per_unit;
    default:
      return word == 0 ? 0 : offset_ + step_ * static_cast<float>(word - 1);
  }
}

float HeldImage::at(int x, int y) const {
  const std::size_t i = index(x, y);
  if (!is_packed()) return floats_.pixels[i];
  return words_.empty() ? static_cast<float>(bytes_[i]) : value_of(words_[i]);
}

const GrayImage& HeldImage::unpacked(GrayImage& room) const {
  if (!is_packed()) return floats_;
  room.width = width;
  room.height = height;
  room.pixels.resize(bytes_.size() + words_.size());
  std::copy(bytes_.begin(), bytes_.end(), room.pixels.begin());
  std::transform(words_.begin(), words_.end(), room.pixels.begin(),
                 [&](std::uint16_t word) { return value_of(word); });
  return room;
}

GrayImage HeldImage::unpacked() const {
  GrayImage room;
  return unpacked(room);
}

HeldImage HeldImage::cropped(int column, int row, int columns, int rows) const {
  HeldImage part = *this;
  part.width = columns;
  part.height = rows;
  if (!is_packed()) part.floats_.width = columns, part.floats_.height = rows;
  const auto crop = [&](auto& values) {
    if (values.empty()) return;
    std::decay_t<decltype(values)> kept;
    kept.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int y = row; y < row + rows; ++y) {
      const auto start = values.begin() + static_cast<std::ptrdiff_t>(index(column, y));
      kept.insert(kept.end(), start, start + columns);
    }
    values = std::move(kept);
  };
  crop(part.floats_.pixels);
  crop(part.bytes_);
  crop(part.words_);
  return part;
}

}  // namespace transformesh
