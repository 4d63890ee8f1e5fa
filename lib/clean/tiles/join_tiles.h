/// Joins the cleaned tiles of a mesh (split_tiles.h) to one mesh. The result has the triangles that
/// clean() gives for the whole mesh, tile by tile. Triangles of different tiles share vertices.
/// Memory holds one tile at a time, and the border edges of all tiles (seams.h). Deterministic.
/// Cost: that of seams.h, and two further passes over all files.
#pragma once

#include <string>

#include "io/streams/atomic_file.h"
#include "transformesh/control.h"

namespace transformesh {

struct JoinResult {
  std::size_t tiles = 0;
  std::size_t vertices = 0, faces = 0;  ///< number of vertices and of faces of the result
  /// Number of vertices of tiles that were merged into other vertices.
  std::size_t joined_vertices = 0;
};

/// Reads the files cleaned_tile_path() of a folder, and writes binary PLY with `comment` added.
/// Throws InputError before writing if a file is missing or belongs to another mesh, or if the
/// joined mesh would have border edges, and GoalError if it would be empty. Throws OutputError if
/// writing fails.
JoinResult join_tiles(const std::string& folder, const std::string& comment, AtomicFile& file,
                      const Progress& progress);

}  // namespace transformesh
