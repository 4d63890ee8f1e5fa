/// PCD 0.7, the format of the Point Cloud Library (R. B. Rusu and S. Cousins, "3D is here: Point
/// Cloud Library", ICRA 2011): points as text, binary, or compressed by LZF. Read only.
#pragma once

#include "io/streams/source.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// True if the first lines that are not comments are those of a PCD header.
bool is_pcd(std::string_view bytes);

/// Reads a mesh without faces. normal_x normal_y normal_z become nx ny nz; rgb and rgba become red
/// green blue (alpha). Every other field with one number becomes a column. Non-finite points, which
/// mark missing measurements in organized clouds, are dropped with a note. Throws InputError.
ReadResult read_pcd(const Source& source);

}  // namespace transformesh
