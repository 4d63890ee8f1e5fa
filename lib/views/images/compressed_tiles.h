/// Lossless compression of 16-bit images that are smooth, such as those of distances: square tiles,
/// each stored as the residuals of a plane in as few bits as they need.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/image.h"

namespace transformesh {

/// Half a byte to one a pixel where it is smooth, 2.2 bytes at most. O(pixels).
class CompressedTiles {
 public:
  CompressedTiles() = default;
  explicit CompressedTiles(const Raster<std::uint16_t>& words);

  bool empty() const { return tiles_.empty(); }
  /// Bytes of memory.
  std::size_t size() const { return tiles_.size() * sizeof(Tile) + bytes_.size(); }
  std::uint16_t at(int x, int y) const;
  /// All of them, row by row.
  void copy_to(std::vector<std::uint16_t>& words) const;

 private:
  /// Word (x, y) of a tile is start + x across + y down and, from `bytes` on, the rest in so many
  /// bits; in 16 it is the word itself.
  struct Tile {
    std::uint32_t bytes = 0;
    std::uint16_t start = 0;
    std::int16_t across = 0, down = 0;
    std::uint16_t bits = 0;
  };
  void copy_tile(const Tile& tile, std::uint16_t* words, int columns, int rows) const;
  void add(const Raster<std::uint16_t>& words, int left, int top);

  int width_ = 0, height_ = 0;
  int columns_ = 0;  ///< of tiles
  std::vector<Tile> tiles_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace transformesh
