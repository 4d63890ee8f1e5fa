/// Images in memory, and their files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/errors.h"

namespace transformesh {

/// A rectangular array of pixels, stored row by row from the top.
template <typename Value>
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<Value> pixels;

  Raster() = default;
  Raster(int columns, int rows, const Value& value = {})
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}

  bool empty() const { return pixels.empty(); }
  Value* row(int y) { return pixels.data() + index(0, y); }
  const Value* row(int y) const { return pixels.data() + index(0, y); }
  Value& at(int x, int y) { return pixels[index(x, y)]; }
  const Value& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// Red, green, blue (sRGB) and straight (not premultiplied) alpha.
using Pixel = std::array<std::uint8_t, 4>;
using Image = Raster<Pixel>;

/// One float per pixel, with pixel centers at integers. Photographs hold the intensities of their
/// file, 0 to 255, without gamma correction. Silhouettes hold 0 outside, 255 inside, and values
/// between at soft edges.
using GrayImage = Raster<float>;

/// Decodes a JPEG, PNG, TIFF or PNM file: intensity 0.299 R + 0.587 G + 0.114 B. Throws InputError,
/// naming the file, if the bytes are incomplete, damaged, or not in one of these formats.
GrayImage decode_photograph(std::string_view bytes, const std::string& name);

/// Returns the bytes of a PNG file: RGB if every pixel is opaque, else RGBA; 8 bits, sRGB. Throws
/// UsageError for an image without pixels, GoalError if libpng fails.
std::string write_png(const Image& image);

}  // namespace transformesh
