/// A picture in memory: rows from the top, four bytes a pixel, alpha not multiplied in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace transformesh {

using Pixel = std::array<std::uint8_t, 4>;  ///< red, green, blue (sRGB) and alpha

struct Image {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;

  Image() = default;
  Image(int columns, int rows)
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  Pixel& at(int x, int y) { return pixels[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace transformesh
