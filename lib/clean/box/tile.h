/// Tiles: parts of a closed mesh that are cleaned alone, on machines that have nothing else of the
/// mesh. A tile is a mesh whose comment holds what this header describes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clean/exterior/surroundings.h"
#include "transformesh/measure.h"

namespace transformesh {

/// Identifies a tile among those of one mesh.
struct TileName {
  std::uint64_t mesh = 0;  ///< hash of all faces of the whole mesh
  std::size_t number = 0;  ///< from 0
  std::size_t count = 0;   ///< of tiles
  bool operator==(const TileName&) const = default;
};

struct Tile {
  TileName name;
  std::uint64_t faces = 0;   ///< hash of the faces of the tile
  Box own;                   ///< faces of the tile are those whose first vertex is in this box
  Box held;                  ///< every face of the mesh that touches this box is in the tile
  ReferencePoint reference;  ///< in `held`
  double cell_size = 1;      ///< side of the cells by which faces were found to be near each other
  Scalar coordinate = Scalar::float64;  ///< the type in which positions are written
};

/// The comment of a tile, and that of the clean pieces of its faces.
std::string tile_comment(const Tile& tile);
std::string cleaned_tile_comment(const TileName& name);

/// Returns what the first such comment holds. Empty if there is none. Throws InputError if the
/// comment is not as tile_comment() writes it.
std::optional<Tile> tile_of(const std::vector<std::string>& comments);
std::optional<TileName> cleaned_tile_of(const std::vector<std::string>& comments);

/// Drops the comments of both kinds.
void drop_tile_comments(std::vector<std::string>& comments);

}  // namespace transformesh
