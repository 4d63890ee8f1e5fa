/// Reads the sparse points of COLMAP's models from points3D.bin or points3D.txt. Reference:
/// COLMAP's manual, "Output format".
#pragma once

#include <optional>

#include "io/streams/source.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns a mesh without faces, with the vertex columns red, green, blue, error (pixels) and
/// track_length (number of photographs). Returns nothing if the bytes are of another format. Text
/// files are recognized by their first line or the name points3D.txt. Binary files have no
/// signature. They are recognized by the name points3D.bin, or if they have exactly the size that
/// follows from the counts in them. Throws InputError, naming the line or the point, if a number is
/// malformed or not finite.
std::optional<Mesh> read_colmap_points(const Source& source);

}  // namespace transformesh
