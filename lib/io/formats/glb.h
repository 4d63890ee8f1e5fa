/// glTF 2.0 in one binary file (ISO/IEC 12113:2022), written only: one primitive of triangles, or
/// of points where there are no faces, in the axes of the mesh. Coordinates are floats. Kept are
/// all vertex columns that are numbers a float can hold: `nx ny nz` as NORMAL, of unit length, `red
/// green blue (alpha)` as COLOR_0, bytes or floats from 0 to 1, `s t` (or `u v`, `texture_u
/// texture_v`) as TEXCOORD_0, whose v runs downwards; any other as the attribute `_NAME` of floats.
/// The face column `texcoord` (obj.h) is TEXCOORD_0 instead: a vertex whose corners have several
/// places in the texture is repeated behind the others. Document::texture is the base color, shown
/// as it is, since photographs have their light in them (KHR_materials_unlit).
/// Comments are in the extras of `asset`.
#pragma once

#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Throws GoalError where the file would be longer than the 4 GB that its header can state.
WriteResult write_glb(const Document& document);

}  // namespace transformesh
