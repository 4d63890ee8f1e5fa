/// Packs boxes into a texture: sorted by decreasing height, on shelves from left to right.
/// Reference: Coffman, Garey, Johnson & Tarjan, "Performance bounds for level-oriented
/// two-dimensional packing algorithms", SIAM J. Computing 9(4), 1980.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace transformesh {

struct Packing {
  std::vector<Eigen::Vector2i> places;  ///< first column and row of each box
  int width = 0;                        ///< a multiple of 4, like `height`
  int height = 0;
};

/// Packs the boxes for several widths and returns the packing of the smallest area. O(n log n),
/// deterministic.
Packing pack_boxes(std::span<const Eigen::Vector2i> sizes);

}  // namespace transformesh
