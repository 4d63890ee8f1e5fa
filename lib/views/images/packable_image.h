/// A gray image that can be packed to save memory. It is stored as floats or, if packed, in at most
/// 16 bits per pixel. A reconstruction from 20 photographs of 1.9 megapixels takes 1.57 GB with
/// packed images and 2.47 GB without, and 17 % more CPU time.
///
/// A packed image takes one bit per pixel if all intensities are 0 or 255, and one byte if they are
/// integers from 0 to 255. Other intensities are rounded to 1/256 and take two bytes. Distances
/// from contours are rounded to 1/64 pixel and clamped to 511 pixels; infinite distances stay
/// infinite. Depths are rounded up by at most a 65534th of their range. Distances and depths take
/// about one byte per pixel (compressed_tiles.h).
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
  /// Returns the size of the image in memory, in bytes.
  std::size_t size() const;

  void pack(Kind kind = Kind::intensities);
  /// Makes all reading functions return blurred intensities, without storing a blurred image. They
  /// equal those of a blurred image that is packed. Returns false, and does nothing, unless the
  /// image is packed with one byte per pixel.
  bool blur_when_read(const ThreeTapBlur& taps);
  GrayImage unpacked() const;
  /// Returns the stored floats if the image is not packed. Otherwise unpacks the image to `room`
  /// and returns `room`.
  const GrayImage& unpacked(GrayImage& room) const;
  /// Returns a rectangle of the image. It must be inside of the image.
  PackableImage cropped(int column, int row, int columns, int rows) const;
  void unpack_rectangle(int column, int row, int columns, int rows, GrayImage& part) const;
  /// Writes the values of `count` pixels of row `y`, from column `x` on, to `out`.
  void read(int x, int y, int count, float* out) const;

  float at(int x, int y) const {
    return floats_.empty() ? packed_at(x, y) : floats_.pixels[index(x, y)];
  }
  /// Requires that the image is not packed.
  float& at(int x, int y) { return floats_.at(x, y); }
  /// Returns an image with the same values and fast access to single pixels. This is usually the
  /// image itself. If it is compressed in tiles (compressed_tiles.h), decompresses the 16-bit codes
  /// to `room` and returns `room`.
  const PackableImage& opened(PackableImage& room) const;
  /// Returns the largest depth of the four pixels from (x, y) to (x + 1, y + 1). The image must be
  /// the result of opened().
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
  float packed_at(int x, int y) const;
  void read_blurred(int x, int y, int columns, int rows, float* out) const;
  void keep(Raster<std::uint16_t> words);
  void find_range(const std::vector<float>& depths);
  std::uint16_t word_of_depth(float depth) const;
  float value_of(std::uint16_t word) const;
  float depth_of(std::uint16_t word) const {
    return word == 0 ? 0 : offset_ + step_ * static_cast<float>(word - 1);
  }

  Kind kind_ = Kind::intensities;
  GrayImage floats_;  ///< empty if the image is packed
  std::vector<bool> bits_;
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint16_t> words_;
  std::optional<ThreeTapBlur> blur_;
  CompressedTiles tiles_;  ///< 16-bit codes of distances and depths
  float offset_ = 0;       ///< depth of the code 1: the smallest positive depth; 0 if there is none
  float step_ = 0;
};

}  // namespace transformesh
