/// Packs rectangles into a texture. They are sorted by decreasing height and placed from left to
/// right in rows (shelves).
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

/// Packs boxes of these sizes into textures of several widths, and returns the packing with the
/// smallest area. O(n log n), deterministic.
Packing pack_boxes(std::span<const Eigen::Vector2i> sizes);

}  // namespace transformesh
