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

constexpr float inside_mask = 255;

bool is_of_mask(float level) { return level == 0 || level == inside_mask; }
bool is_byte(float level) { return level >= 0 && level <= 255 && level == std::floor(level); }

}  // namespace

std::size_t HeldImage::size() const {
  return sizeof(float) * floats_.pixels.size() + (bits_.size() + 7) / 8 + bytes_.size() +
         2 * words_.size();
}

void HeldImage::pack(Kind kind) {
  if (is_packed() || empty()) return;
  kind_ = kind;
  const std::vector<float> pixels = std::exchange(floats_, GrayImage()).pixels;
  if (kind == Kind::levels && std::all_of(pixels.begin(), pixels.end(), is_of_mask)) {
    bits_.resize(pixels.size());
    std::transform(pixels.begin(), pixels.end(), bits_.begin(),
                   [](float level) { return level > 0; });
    return;
  }
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
  if (!words_.empty()) return value_of(words_[i]);
  if (!bytes_.empty()) return bytes_[i];
  if (!bits_.empty()) return bits_[i] ? inside_mask : 0;
  return floats_.pixels[i];
}

const GrayImage& HeldImage::unpacked(GrayImage& room) const {
  if (!is_packed()) return floats_;
  room.width = width;
  room.height = height;
  room.pixels.resize(bits_.size() + bytes_.size() + words_.size());
  std::transform(bits_.begin(), bits_.end(), room.pixels.begin(),
                 [](bool is_inside) { return is_inside ? inside_mask : 0.0F; });
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
  HeldImage part;
  part.width = columns;
  part.height = rows;
  if (!is_packed()) part.floats_.width = columns, part.floats_.height = rows;
  const auto crop = [&](const auto& values, auto& kept) {
    if (values.empty()) return;
    kept.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (int y = row; y < row + rows; ++y) {
      const auto start = values.begin() + static_cast<std::ptrdiff_t>(index(column, y));
      kept.insert(kept.end(), start, start + columns);
    }
  };
  crop(floats_.pixels, part.floats_.pixels);
  crop(bits_, part.bits_);
  crop(bytes_, part.bytes_);
  crop(words_, part.words_);
  part.kind_ = kind_;
  part.offset_ = offset_;
  part.step_ = step_;
  return part;
}

}  // namespace transformesh
