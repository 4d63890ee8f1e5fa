/// A gray image that can be packed while it is not used: floats, or at most 16 bits a pixel if many
/// large images are held together. A reconstruction from 20 photographs of 1.9 megapixels takes
/// 1.57 GB with packed images and 2.47 GB without, and 17 % more CPU time.
///
/// Packed are intensities, of which those of masks take a bit, other ones of 8 bits a byte, and
/// others are rounded to 1/256; distances to contours, rounded to 1/64 pixel and cut off at 511
/// pixels but for those that are infinite; and depths, rounded up by at most a 65534th of their
/// range. Both take about a byte (compressed_tiles.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "transformesh/image.h"
#include "views/images/compressed_tiles.h"
#include "views/images/three_tap_blur.h"

namespace transformesh {

class PackableImage {
 public:
  enum class Kind { intensities, distances, depths };

  int width = 0;
  int height = 0;

  PackableImage() = default;
  PackableImage(GrayImage image)  // NOLINT(google-explicit-constructor): it is that image
      : width(image.width), height(image.height), floats_(std::move(image)) {}
  operator GrayImage() const { return unpacked(); }  // NOLINT(google-explicit-constructor)

  bool empty() const { return width == 0 || height == 0; }
  bool is_packed() const {
    return !bits_.empty() || !bytes_.empty() || !words_.empty() || !tiles_.empty();
  }
  /// Bytes of memory.
  std::size_t size() const;

  void pack(Kind kind = Kind::intensities);
  /// Blurs an image of packed bytes whenever it is read, with the same result as a blurred image
  /// that is packed. False, and nothing is done, where it is none.
  bool blur_when_read(const ThreeTapBlur& taps);
  GrayImage unpacked() const;
  /// The image itself where it is not packed, else `room`, which it is unpacked to.
  const GrayImage& unpacked(GrayImage& room) const;
  /// Part of it, which must be inside.
  PackableImage cropped(int column, int row, int columns, int rows) const;
  void unpack_rectangle(int column, int row, int columns, int rows, GrayImage& part) const;
  /// `count` pixels of a row, from (x, y) on.
  void read(int x, int y, int count, float* out) const;

  float at(int x, int y) const;
  /// Only where it is not packed.
  float& at(int x, int y) { return floats_.at(x, y); }
  /// The image itself, or, where it is packed in tiles, `room` with its words: quick to read.
  const PackableImage& opened(PackableImage& room) const;
  /// Of depths that are opened, the largest of four: (x, y), and to the right of it and below.
  float largest_of_four(int x, int y) const {
    const auto largest = [&](const auto& values) {
      const auto* const top = values.data() + index(x, y);
      const auto* const bottom = top + width;
      return std::max(std::max(top[0], top[1]), std::max(bottom[0], bottom[1]));
    };
    return words_.empty() ? largest(floats_.pixels) : depth_of(largest(words_));
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  void read_blurred(int x, int y, int columns, int rows, float* out) const;
  void keep(Raster<std::uint16_t> words);
  void find_range(const std::vector<float>& depths);
  std::uint16_t word_of_depth(float depth) const;
  float value_of(std::uint16_t word) const;
  float depth_of(std::uint16_t word) const {
    return word == 0 ? 0 : offset_ + step_ * static_cast<float>(word - 1);
  }

  Kind kind_ = Kind::intensities;
  GrayImage floats_;  ///< empty where it is packed
  std::vector<bool> bits_;
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint16_t> words_;
  std::optional<ThreeTapBlur> blur_;
  CompressedTiles tiles_;  ///< of distances and depths
  float offset_ = 0;       ///< of depths
  float step_ = 0;
};

}  // namespace transformesh
