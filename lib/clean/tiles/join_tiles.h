/// Joins the clean pieces of all tiles of a mesh (split_tiles.h): the triangles of clean() for the
/// whole mesh, tile by tile, with its vertices. One tile at a time is in memory, and the seams
/// (seams.h). Deterministic.
#pragma once

#include <string>

#include "io/streams/atomic_file.h"
#include "transformesh/control.h"

namespace transformesh {

struct JoinResult {
  std::size_t tiles = 0;
  std::size_t vertices = 0, faces = 0;  ///< of the result
  std::size_t joined_vertices = 0;      ///< vertices of tiles that became one with others
};

/// Reads the files cleaned_tile_path() of a folder and writes binary PLY with one more comment.
/// Throws InputError if a file is missing, is of another mesh, or leaves seams open, before it
/// writes, and OutputError.
JoinResult join_tiles(const std::string& folder, const std::string& comment, AtomicFile& file,
                      const Progress& progress);

}  // namespace transformesh
