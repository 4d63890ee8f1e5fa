/// A gray image as it is held while it is not worked upon: as floats, or packed in 8 or 16 bits
/// where many large images are held together.
///
/// Packed are levels, of which those of 8 bits stay as they are and others are rounded to 1/256;
/// distances to contours, rounded to 1/64 pixel and cut off at 511 pixels but for those that are
/// infinite; and depths, rounded up by at most a 65534th of their range.
#pragma once

#include <cstdint>
#include <vector>

#include "tm/views/images/gray_image.h"

namespace transformesh {

class HeldImage {
 public:
  enum class Kind { levels, distances, depths };

  int width = 0;
  int height = 0;

  HeldImage() = default;
  HeldImage(GrayImage image)  // NOLINT(google-explicit-constructor): it is that image
      : width(image.width), height(image.height), floats_(std::move(image)) {}
  operator GrayImage() const { return unpacked(); }  // NOLINT(google-explicit-constructor)

  bool empty() const { return width == 0 || height == 0; }
  bool is_packed() const { return !bytes_.empty() || !words_.empty(); }
  /// Bytes of memory.
  std::size_t size() const;

  void pack(Kind kind = Kind::levels);
  GrayImage unpacked() const;
  /// The image itself where it is not packed, else `room`, which it is unpacked to.
  const GrayImage& unpacked(GrayImage& room) const;
  /// Part of it, which must be inside.
  HeldImage cropped(int column, int row, int columns, int rows) const;

  float at(int x, int y) const;
  /// Only where it is not packed.
  float& at(int x, int y) { return floats_.at(x, y); }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  float value_of(std::uint16_t word) const;

  Kind kind_ = Kind::levels;
  GrayImage floats_;  ///< empty where it is packed
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint16_t> words_;
  float offset_ = 0;  ///< of depths
  float step_ = 0;
};

}  // namespace transformesh
