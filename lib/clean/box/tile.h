/// Tiles: parts of a closed mesh that are cleaned alone, on machines that do not have the rest of
/// the mesh. A tile is a mesh with a comment that contains the data described here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clean/exterior/surroundings.h"
#include "transformesh/measure.h"

namespace transformesh {

struct TileName {
  std::uint64_t mesh = 0;  ///< hash of all faces of the whole mesh
  std::size_t number = 0;  ///< in [0, count)
  std::size_t count = 0;   ///< number of tiles
  bool operator==(const TileName&) const = default;
};

struct Tile {
  TileName name;
  std::uint64_t faces = 0;   ///< hash of the faces of the tile
  Box own;                   ///< own faces are those whose first vertex is in this box
  Box held;                  ///< the tile contains every face of the mesh that touches this box
  ReferencePoint reference;  ///< a point in `held`
  double cell_size = 1;      ///< size of the cells that determine which faces are near each other
  Scalar coordinate = Scalar::float64;  ///< type in which positions are written
};

/// Returns the comment of a tile; cleaned_tile_comment() returns that of the clean pieces of a
/// tile.
std::string tile_comment(const Tile& tile);
std::string cleaned_tile_comment(const TileName& name);

/// Returns the data of the first tile comment, or nothing if there is none. Throws InputError if
/// the comment is malformed. cleaned_tile_of() does the same for cleaned tiles.
std::optional<Tile> tile_of(const std::vector<std::string>& comments);
std::optional<TileName> cleaned_tile_of(const std::vector<std::string>& comments);

/// True if there is a comment of either kind, well-formed or not.
bool has_tile_comment(const std::vector<std::string>& comments);

/// Removes the comments of both kinds.
void drop_tile_comments(std::vector<std::string>& comments);

}  // namespace transformesh
