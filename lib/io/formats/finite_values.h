/// Handles non-finite values, which occur in scans: drops them with a count, or rejects them if
/// reading is strict.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/streams/source.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Drops the vertices with a non-finite coordinate and the faces that use them. `dropped_faces` is
/// the number of faces dropped earlier for this reason; the note states the sum. Does nothing if
/// all coordinates are finite.
void drop_points_not_finite(Mesh& mesh, std::size_t dropped_faces, const std::string& format,
                            std::vector<std::string>& notes);

/// Sets normals (nx ny nz) and colors (red green blue, with alpha if present) to zero in the rows
/// where one of their values is not finite. Throws InputError instead if reading is strict.
/// `element` is the name of a row in messages.
void zero_values_not_finite(Columns& columns, const Source& source, const std::string& element,
                            const std::string& format, std::vector<std::string>& notes);

/// Adds a note such as "ply: 1 normal of a vertex is not a finite number and becomes 0".
void note_zeroed(std::size_t count, const std::string& what, const std::string& format,
                 std::vector<std::string>& notes);

}  // namespace transformesh
