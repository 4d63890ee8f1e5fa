/// Tiles: parts of a closed mesh that are cleaned separately, without the rest of the mesh in
/// memory. A tile is stored as a mesh file with a comment that contains the data described here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clean/exterior/surroundings.h"
#include "transformesh/measure.h"

namespace transformesh {

struct TileName {
  std::uint64_t mesh = 0;  ///< hash of all faces of the whole mesh
  std::size_t number = 0;  ///< number of the tile, in [0, count)
  std::size_t count = 0;   ///< number of tiles
  bool operator==(const TileName&) const = default;
};

struct Tile {
  TileName name;
  std::uint64_t faces = 0;  ///< hash of the faces of the tile
  /// The own faces, which only this tile cleans, are those with their first vertex in this box.
  Box own;
  Box held;                  ///< the tile contains every face of the mesh that touches this box
  ReferencePoint reference;  ///< a point in `held` with its winding number
  double cell_size = 1;  ///< width of the grid cells that determine which faces are near each other
  Scalar coordinate = Scalar::float64;  ///< type in which positions are written
};

/// Returns the comment of a tile. cleaned_tile_comment() returns the comment of the file with the
/// cleaned pieces of a tile.
std::string tile_comment(const Tile& tile);
std::string cleaned_tile_comment(const TileName& name);

/// Returns the data of the first tile comment, or nothing if there is none. Throws InputError if
/// the comment is malformed. cleaned_tile_of() does the same for cleaned tiles.
std::optional<Tile> tile_of(const std::vector<std::string>& comments);
std::optional<TileName> cleaned_tile_of(const std::vector<std::string>& comments);

/// True if any comment is that of a tile or of a cleaned tile, even if it is malformed.
bool has_tile_comment(const std::vector<std::string>& comments);

/// Removes the comments that tile_comment() and cleaned_tile_comment() made.
void drop_tile_comments(std::vector<std::string>& comments);

}  // namespace transformesh
