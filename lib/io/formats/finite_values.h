/// Values that are not finite numbers, as scans have them: they are dropped with a count, or
/// refused by strict reading.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/streams/source.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Drops the vertices with a coordinate that is not finite and the faces that use them;
/// `dropped_faces` were dropped before for that reason. Does nothing else: notes say both counts.
void drop_points_not_finite(Mesh& mesh, std::size_t dropped_faces, const std::string& format,
                            std::vector<std::string>& notes);

/// Makes normals (nx ny nz) and colors (red green blue, with alpha if there is one) zero in the
/// rows of vertices or faces where one of their values is not finite. Throws InputError instead if
/// the source is read strictly. `element` is what messages call a row.
void zero_values_not_finite(Columns& columns, const Source& source, const std::string& element,
                            const std::string& format, std::vector<std::string>& notes);

/// "ply: 1 normal of a vertex is not a finite number and becomes 0", for each of `count`.
void note_zeroed(std::size_t count, const std::string& what, const std::string& format,
                 std::vector<std::string>& notes);

}  // namespace transformesh
