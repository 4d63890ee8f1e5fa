/// Places boxes in a texture, on shelves: the highest first, from left to right.
/// Reference: Coffman, Garey, Johnson & Tarjan, "Performance bounds for level-oriented
/// two-dimensional packing algorithms", SIAM J. Computing 9(4), 1980.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace transformesh {

struct Packing {
  std::vector<Eigen::Vector2i> places;  ///< of each box its first column and row
  int width = 0;                        ///< multiples of 4
  int height = 0;
};

/// Of some widths from as wide as high on the one with the smallest area. O(n log n),
/// deterministic.
Packing pack_boxes(std::span<const Eigen::Vector2i> sizes);

}  // namespace transformesh
