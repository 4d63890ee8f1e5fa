/// Pixels in memory: rows from the top.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace transformesh {

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

/// Red, green, blue (sRGB) and alpha, which is not multiplied in.
using Pixel = std::array<std::uint8_t, 4>;
using Image = Raster<Pixel>;

}  // namespace transformesh
