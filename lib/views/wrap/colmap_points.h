/// The points of COLMAP's models, points3D.bin and points3D.txt. Reference: COLMAP's manual,
/// "Output format".
#pragma once

#include <optional>

#include "io/streams/source.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns a mesh without faces, with the vertex columns red, green, blue, error (pixels) and
/// track_length (number of photographs). Returns nothing if the bytes are of another format. Text
/// is recognized by its title or the name points3D.txt; binary files, which have no signature, by
/// having exactly the size that their counts state. Throws InputError, naming the line or the
/// point, if a number is malformed or not finite.
std::optional<Mesh> read_colmap_points(const Source& source);

}  // namespace transformesh
