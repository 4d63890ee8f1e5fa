/// Lossless compression of smooth 16-bit images, such as coded distances. The image is divided into
/// square tiles. For each tile, the coefficients of a plane and the differences from this plane are
/// stored, with as many bits as the differences need.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/image.h"

namespace transformesh {

/// Takes half a byte to one byte per pixel of smooth images, and at most 2.2 bytes. O(pixels).
class CompressedTiles {
 public:
  CompressedTiles() = default;
  explicit CompressedTiles(const Raster<std::uint16_t>& words);

  bool empty() const { return tiles_.empty(); }
  /// Returns the size of the compressed image in memory, in bytes.
  std::size_t size() const { return tiles_.size() * sizeof(Tile) + bytes_.size(); }
  std::uint16_t at(int x, int y) const;
  /// Decompresses all 16-bit numbers of the image to `words`, row by row.
  void copy_to(std::vector<std::uint16_t>& words) const;

 private:
  /// The number at (x, y) in a tile is `start` + x * `across` + y * `down` plus a residual. The
  /// residuals of a tile begin at index `bytes` of `bytes_` and have `bits` bits each. If `bits` is
  /// 16, the numbers themselves are stored instead.
  struct Tile {
    std::uint32_t bytes = 0;
    std::uint16_t start = 0;
    std::int16_t across = 0, down = 0;
    std::uint16_t bits = 0;
  };
  void copy_tile(const Tile& tile, std::uint16_t* words, int columns, int rows) const;
  void add(const Raster<std::uint16_t>& words, int left, int top);

  int width_ = 0, height_ = 0;
  int columns_ = 0;  ///< number of columns of tiles
  std::vector<Tile> tiles_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace transformesh
