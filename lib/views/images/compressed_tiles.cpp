#include "views/images/compressed_tiles.h"

#include <algorithm>
#include <array>

namespace transformesh {
namespace {

/// Side of a tile in pixels. The numbers in a tile are stored as a plane fitted to them and
/// residuals. Larger tiles need fewer planes but more bits per residual.
constexpr int side = 8;
constexpr std::size_t area = std::size_t{side} * side;

/// The 16-bit numbers of a tile. Outside of the image, a tile repeats the last row and column of
/// the image.
using Square = std::array<int, area>;

Square square_at(const Raster<std::uint16_t>& words, int left, int top) {
  Square square;
  for (int y = 0; y < side; ++y) {
    const std::uint16_t* const row = words.row(std::min(top + y, words.height - 1));
    for (int x = 0; x < side; ++x)
      square[static_cast<std::size_t>(side * y + x)] = row[std::min(left + x, words.width - 1)];
  }
  return square;
}

/// Returns the number of bits that signed numbers from `least` to `most` need: 0, 4, 8 or 16.
std::uint16_t bits_of(int least, int most) {
  if (least == 0 && most == 0) return 0;
  if (least >= -8 && most < 8) return 4;
  return least >= -128 && most < 128 ? 8 : 16;
}

std::uint16_t word_at(const std::uint8_t* bytes, std::size_t i) {
  return static_cast<std::uint16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8);
}

int signed_byte_at(const std::uint8_t* bytes, std::size_t i) {
  return static_cast<std::int8_t>(bytes[i]);
}

/// Returns the signed 4-bit number at index `i`.
int half_byte_at(const std::uint8_t* bytes, std::size_t i) {
  const int upper = i % 2 == 0 ? bytes[i / 2] << 4 : bytes[i / 2];
  return static_cast<std::int8_t>(upper & 0xf0) / 16;
}

}  // namespace

CompressedTiles::CompressedTiles(const Raster<std::uint16_t>& words)
    : width_(words.width), height_(words.height), columns_((words.width + side - 1) / side) {
  tiles_.reserve(static_cast<std::size_t>(columns_) *
                 static_cast<std::size_t>((words.height + side - 1) / side));
  for (int top = 0; top < words.height; top += side)
    for (int left = 0; left < words.width; left += side) add(words, left, top);
  bytes_.shrink_to_fit();
}

void CompressedTiles::add(const Raster<std::uint16_t>& words, int left, int top) {
  Square square = square_at(words, left, top);
  const int start = square[0];
  const int across = (square[side - 1] - start) / (side - 1);
  const int down = (square[area - side] - start) / (side - 1);
  Square rest;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto i = static_cast<std::size_t>(side * y + x);
      rest[i] = square[i] - (start + x * across + y * down);
    }
  const auto [least, most] = std::minmax_element(rest.begin(), rest.end());
  const std::uint16_t bits = bits_of(*least, *most);
  tiles_.push_back({static_cast<std::uint32_t>(bytes_.size()), static_cast<std::uint16_t>(start),
                    static_cast<std::int16_t>(across), static_cast<std::int16_t>(down), bits});
  for (std::size_t i = 0; i < area; ++i) {
    const int value = bits == 16 ? square[i] : rest[i];
    if (bits == 4 && i % 2 == 0) bytes_.push_back(static_cast<std::uint8_t>(value & 15));
    if (bits == 4 && i % 2 == 1) bytes_.back() |= static_cast<std::uint8_t>((value & 15) << 4);
    if (bits >= 8) bytes_.push_back(static_cast<std::uint8_t>(value & 255));
    if (bits == 16) bytes_.push_back(static_cast<std::uint8_t>(value >> 8));
  }
}

std::uint16_t CompressedTiles::at(int x, int y) const {
  const Tile& tile =
      tiles_[static_cast<std::size_t>(y / side) * static_cast<std::size_t>(columns_) +
             static_cast<std::size_t>(x / side)];
  const int column = x % side;
  const int row = y % side;
  const auto i = static_cast<std::size_t>(side * row + column);
  const std::uint8_t* const bytes = bytes_.data() + tile.bytes;
  if (tile.bits == 16) return word_at(bytes, i);
  int value = tile.start + column * tile.across + row * tile.down;
  if (tile.bits == 8) value += signed_byte_at(bytes, i);
  if (tile.bits == 4) value += half_byte_at(bytes, i);
  return static_cast<std::uint16_t>(value);
}

void CompressedTiles::copy_tile(const Tile& tile, std::uint16_t* words, int columns,
                                int rows) const {
  const std::uint8_t* const bytes = bytes_.data() + tile.bytes;
  const auto copy = [&](const auto& rest_at) {
    for (int y = 0; y < rows; ++y) {
      std::uint16_t* const row = words + static_cast<std::ptrdiff_t>(y) * width_;
      const int start = tile.start + y * tile.down;
      for (int x = 0; x < columns; ++x)
        row[x] = static_cast<std::uint16_t>(start + x * tile.across +
                                            rest_at(static_cast<std::size_t>(side * y + x)));
    }
  };
  if (tile.bits == 0) return copy([](std::size_t) { return 0; });
  if (tile.bits == 4) return copy([&](std::size_t i) { return half_byte_at(bytes, i); });
  if (tile.bits == 8) return copy([&](std::size_t i) { return signed_byte_at(bytes, i); });
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      words[static_cast<std::ptrdiff_t>(y) * width_ + x] =
          word_at(bytes, static_cast<std::size_t>(side * y + x));
}

void CompressedTiles::copy_to(std::vector<std::uint16_t>& words) const {
  words.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  const Tile* tile = tiles_.data();
  for (int top = 0; top < height_; top += side)
    for (int left = 0; left < width_; left += side)
      copy_tile(*tile++, words.data() + static_cast<std::ptrdiff_t>(top) * width_ + left,
                std::min(side, width_ - left), std::min(side, height_ - top));
}

}  // namespace transformesh
