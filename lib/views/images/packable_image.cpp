#include "views/images/packable_image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace transformesh {
namespace {

/// Intensities are stored in 16 bits in steps of 1 / 256.
constexpr float intensities_per_unit = 256;
/// Distances are stored in 16 bits in steps of 1 / 64 pixel.
constexpr float distances_per_unit = 64;
constexpr float no_distance = 32768;        ///< 16-bit code of distance 0
constexpr std::uint16_t last_word = 65535;  ///< largest 16-bit number
constexpr float infinity = std::numeric_limits<float>::infinity();

std::uint16_t word_of(float value) {
  return static_cast<std::uint16_t>(std::clamp(value + 0.5F, 0.0F, 65535.0F));
}

/// Encodes a distance in 16 bits. The codes 0 and 65535 represent negative and positive infinity.
std::uint16_t word_of_distance(float distance) {
  if (std::isinf(distance)) return distance < 0 ? 0 : last_word;
  return word_of(std::clamp(no_distance + distances_per_unit * distance, 1.0F, 65534.0F));
}

float distance_of(std::uint16_t word) {
  if (word == 0 || word == last_word) return word == 0 ? -infinity : infinity;
  return (static_cast<float>(word) - no_distance) / distances_per_unit;
}

float intensity_of(std::uint16_t word) { return static_cast<float>(word) / intensities_per_unit; }

constexpr float inside_mask = 255;  ///< intensity of pixels inside a mask

bool is_of_mask(float intensity) { return intensity == 0 || intensity == inside_mask; }
bool is_byte(float intensity) {
  return intensity >= 0 && intensity <= 255 && intensity == std::floor(intensity);
}

}  // namespace

std::size_t PackableImage::size() const {
  return sizeof(float) * floats_.pixels.size() + (bits_.size() + 7) / 8 + bytes_.size() +
         2 * words_.size() + tiles_.size();
}

void PackableImage::pack(Kind kind) {
  if (is_packed() || empty()) return;
  kind_ = kind;
  const std::vector<float> pixels = std::exchange(floats_, GrayImage()).pixels;
  const auto are_all = [&](bool (*is)(float)) {
    return kind == Kind::intensities && std::all_of(pixels.begin(), pixels.end(), is);
  };
  if (are_all(is_of_mask)) {
    bits_.resize(pixels.size());
    std::transform(pixels.begin(), pixels.end(), bits_.begin(), [](float v) { return v > 0; });
    return;
  }
  if (are_all(is_byte)) {
    bytes_.assign(pixels.begin(), pixels.end());
    return;
  }
  if (kind == Kind::depths) find_range(pixels);
  Raster<std::uint16_t> words(width, height);
  std::transform(pixels.begin(), pixels.end(), words.pixels.begin(),
                 [&](float value) -> std::uint16_t {
                   if (kind == Kind::intensities) return word_of(intensities_per_unit * value);
                   if (kind == Kind::distances) return word_of_distance(value);
                   return word_of_depth(value);
                 });
  keep(std::move(words));
}

void PackableImage::find_range(const std::vector<float>& depths) {
  float nearest = infinity;
  float farthest = 0;
  for (const float depth : depths) {
    if (depth == 0) continue;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  offset_ = farthest > 0 ? nearest : 0;
  step_ = (farthest - offset_) / (last_word - 1);
}

std::uint16_t PackableImage::word_of_depth(float depth) const {
  if (depth == 0) return 0;
  if (!(step_ > 0)) return 1;
  return static_cast<std::uint16_t>(
      1 + std::clamp(std::ceil((depth - offset_) / step_), 0.0F, 65534.0F));
}

void PackableImage::keep(Raster<std::uint16_t> words) {
  if (kind_ == Kind::intensities)
    words_ = std::move(words.pixels);
  else
    tiles_ = CompressedTiles(words);
}

bool PackableImage::blur_when_read(const ThreeTapBlur& taps) {
  if (bytes_.empty() || blur_ || width < 2 || height < 2) return false;
  blur_ = taps;
  return true;
}

// Blurs a rectangle of the image and writes it to `out`. Rounds intensities to 1/256 as pack()
// does, so that they equal those of a blurred image that was packed.
void PackableImage::read_blurred(int x, int y, int columns, int rows, float* out) const {
  blur_rectangle(bytes_, width, height, *blur_, {x, y}, columns, rows, out);
  const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(columns) * rows;
  std::transform(out, out + count, out, [](float intensity) {
    return static_cast<float>(static_cast<int>(
               std::clamp(intensities_per_unit * intensity + 0.5F, 0.0F, 65535.0F))) /
           intensities_per_unit;
  });
}

void PackableImage::read(int x, int y, int count, float* out) const {
  if (blur_) return read_blurred(x, y, count, 1, out);
  const auto from = [&](const auto& values, const auto& value_of) {
    const auto start = values.begin() + static_cast<std::ptrdiff_t>(index(x, y));
    std::transform(start, start + count, out, value_of);
  };
  if (!bits_.empty()) return from(bits_, [](bool bit) { return bit ? inside_mask : 0.0F; });
  if (!bytes_.empty())
    return from(bytes_, [](std::uint8_t byte) { return static_cast<float>(byte); });
  if (!words_.empty() && kind_ == Kind::intensities) return from(words_, intensity_of);
  if (!words_.empty()) return from(words_, [&](std::uint16_t word) { return value_of(word); });
  if (tiles_.empty()) return from(floats_.pixels, [](float value) { return value; });
  for (int i = 0; i < count; ++i) out[i] = value_of(tiles_.at(x + i, y));
}

const PackableImage& PackableImage::opened(PackableImage& room) const {
  if (tiles_.empty()) return *this;
  room.width = width;
  room.height = height;
  room.kind_ = kind_;
  room.offset_ = offset_;
  room.step_ = step_;
  tiles_.copy_to(room.words_);
  return room;
}

float PackableImage::value_of(std::uint16_t word) const {
  if (kind_ == Kind::intensities) return intensity_of(word);
  return kind_ == Kind::distances ? distance_of(word) : depth_of(word);
}

float PackableImage::packed_at(int x, int y) const {
  if (!tiles_.empty()) return value_of(tiles_.at(x, y));
  if (blur_) {
    float intensity = 0;
    read_blurred(x, y, 1, 1, &intensity);
    return intensity;
  }
  const std::size_t i = index(x, y);
  if (!bits_.empty()) return bits_[i] ? inside_mask : 0.0F;
  if (!bytes_.empty()) return static_cast<float>(bytes_[i]);
  return value_of(words_[i]);
}

void PackableImage::unpack_rectangle(int column, int row, int columns, int rows,
                                     GrayImage& part) const {
  part.width = columns;
  part.height = rows;
  part.pixels.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  if (blur_) return read_blurred(column, row, columns, rows, part.pixels.data());
  for (int y = 0; y < rows; ++y) read(column, row + y, columns, part.row(y));
}

const GrayImage& PackableImage::unpacked(GrayImage& room) const {
  if (!is_packed()) return floats_;
  unpack_rectangle(0, 0, width, height, room);
  return room;
}

GrayImage PackableImage::unpacked() const {
  GrayImage room;
  return unpacked(room);
}

PackableImage PackableImage::cropped(int column, int row, int columns, int rows) const {
  if (blur_) {
    GrayImage intensities;
    unpack_rectangle(column, row, columns, rows, intensities);
    PackableImage packed = std::move(intensities);
    packed.pack();
    return packed;
  }
  PackableImage part;
  part.width = columns;
  part.height = rows;
  part.kind_ = kind_;
  part.offset_ = offset_;
  part.step_ = step_;
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
  if (!is_packed()) part.floats_.width = columns, part.floats_.height = rows;
  if (tiles_.empty()) return part;
  Raster<std::uint16_t> words(columns, rows);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) words.at(x, y) = tiles_.at(column + x, row + y);
  part.keep(std::move(words));
  return part;
}

}  // namespace transformesh
