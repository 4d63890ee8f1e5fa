/// A gray image in memory: rows from the top, one float a pixel, pixel centers at integers.
/// Photographs hold the gray levels of their file, 0 to 255, without gamma; silhouettes hold 0
/// outside and 255 inside, and levels between along soft edges (contour_distance.h).
#pragma once

#include <cstddef>
#include <vector>

namespace transformesh {

struct GrayImage {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;

  GrayImage() = default;
  GrayImage(int columns, int rows, float level = 0)
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), level) {}

  bool empty() const { return pixels.empty(); }
  float* row(int y) { return pixels.data() + index(0, y); }
  const float* row(int y) const { return pixels.data() + index(0, y); }
  float& at(int x, int y) { return pixels[index(x, y)]; }
  float at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// The image under a Gaussian of this `deviation` in pixels, > 0, that is cut off at four
/// deviations. Beyond the outermost pixels the image goes on mirrored at them. O(pixels *
/// deviation); the same bytes on every machine.
GrayImage gaussian_blur(const GrayImage& image, double deviation);

}  // namespace transformesh
