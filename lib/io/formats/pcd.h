/// PCD 0.7 of the Point Cloud Library (R. B. Rusu and S. Cousins, 3D is here: Point Cloud Library,
/// ICRA 2011): points as text, binary, or compressed by LZF. Read only.
#pragma once

#include "io/streams/source.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// True if the first lines outside of comments are those of the format.
bool is_pcd(std::string_view bytes);

/// Reads a mesh without faces: normal_x normal_y normal_z become nx ny nz, rgb and rgba red green
/// blue (alpha), every other field of one number a column. Points that are not finite, which
/// organized clouds have where nothing was measured, are dropped with a note. Throws InputError.
ReadResult read_pcd(const Source& source);

}  // namespace transformesh
