/// Splits a closed mesh that may be larger than memory into tiles (box/tile.h). A tile has its own
/// faces and every other face that clean_tile() needs. Rows of vertices and faces, with their
/// properties, are those of the file; their order stays. Vertices that no face uses are left out.
///
/// The file is read six times in its order, and once more tile by tile. Memory: 64 KB per tile,
/// about 30 bytes per face of the largest tile, and one position per face up to a million. Each
/// cell (cell_grid.h) that faces of a tile have outside of its box takes 64 bytes. Deterministic.
#pragma once

#include <functional>

#include "io/formats/ply_rows.h"
#include "io/streams/atomic_file.h"
#include "transformesh/control.h"

namespace transformesh {

struct SplitResult {
  std::size_t faces = 0;          ///< of the mesh
  std::size_t tile_faces = 0;     ///< in all tiles together
  std::size_t largest_tile = 0;   ///< its faces
  std::size_t empty_tiles = 0;    ///< without faces of their own
  std::vector<AtomicFile> files;  ///< complete, and not yet committed
};

/// Writes tiles into a folder, as tile_path() names them. Makes the folder, and removes it if that
/// fails and it is empty. Throws InputError if the mesh
/// has no faces, is open or not oriented, and OutputError.
SplitResult split_tiles(const PlyRows& rows, std::size_t count, const std::string& folder,
                        const Progress& progress);

/// Returns "FOLDER/tile-03.ply", or the name of its clean pieces, "FOLDER/clean-03.ply".
std::string tile_path(const std::string& folder, std::size_t number, std::size_t count);
std::string cleaned_tile_path(const std::string& folder, std::size_t number, std::size_t count);

}  // namespace transformesh
