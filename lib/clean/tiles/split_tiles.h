/// Splits a closed mesh, which may be larger than memory, into tiles (box/tile.h). The faces of a
/// tile are its own faces, which only this tile cleans, and all other faces that clean_tile() needs
/// for this purpose. Rows of vertices and faces, with their properties, are copied from the file in
/// their order. Vertices that no face uses are omitted.
///
/// The file is read six times sequentially, and once more tile by tile. Memory: 64 KB per tile,
/// about 30 bytes per face of the largest tile, and the positions of at most a million samples.
/// Each grid cell (cell_grid.h) that the faces of a tile touch outside its box takes 64 bytes. The
/// box of a tile contains the first vertices of its own faces. Deterministic.
#pragma once

#include <functional>

#include "io/formats/ply_rows.h"
#include "io/streams/atomic_file.h"
#include "transformesh/control.h"

namespace transformesh {

struct SplitResult {
  std::size_t faces = 0;         ///< number of faces of the mesh
  std::size_t tile_faces = 0;    ///< number of faces of all tiles together
  std::size_t largest_tile = 0;  ///< number of faces of the largest tile
  std::size_t empty_tiles = 0;   ///< number of tiles without faces of their own
  /// Tile files whose contents are written completely, but that do not have their final names yet.
  std::vector<AtomicFile> files;
};

/// Writes tiles to the files tile_path() of a folder. Creates the folder; on failure the folder is
/// removed if it is empty. Throws InputError if the mesh has no faces, is open, or is not oriented.
/// Throws OutputError if writing fails.
SplitResult split_tiles(const PlyRows& rows, std::size_t count, const std::string& folder,
                        const Progress& progress);

/// Returns the path of a tile file, such as "FOLDER/tile-03.ply". cleaned_tile_path() returns the
/// path of the file with the cleaned faces of this tile, such as "FOLDER/clean-03.ply".
std::string tile_path(const std::string& folder, std::size_t number, std::size_t count);
std::string cleaned_tile_path(const std::string& folder, std::size_t number, std::size_t count);

}  // namespace transformesh
