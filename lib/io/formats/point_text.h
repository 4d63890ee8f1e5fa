/// Points as plain text without a header, as .P3D, .xyz and .pts files hold them: lines of x y z,
/// or of x y z nx ny nz. Where the last three are colors, whole
/// numbers up to 255 or shares of no unit length, there are no normals. Empty lines and what
/// follows a # are skipped.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// Whether the first line holds three or six numbers. An .off file without its keyword begins so
/// too, and is detected by its name.
bool is_point_text(const Source& source);

/// Throws InputError where the first line holds numbers and commas only, but no point: it says what
/// is wrong with them.
void check_point_text(const Source& source);

/// A mesh without faces, with vertex columns nx ny nz where lines have six numbers. Points that are
/// not finite are dropped and normals that are not become 0, with a note, as in read_mesh(). Throws
/// InputError with the line for anything else, and for lines of different lengths.
ReadResult read_point_text(const Source& source);

}  // namespace transformesh
