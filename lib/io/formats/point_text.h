/// Points as text without a header, as in .p3d, .xyz and .pts files: lines of x y z, or of x y z
/// and three more numbers. The three more numbers are a color if they are integers up to 255 or
/// fractions whose vector does not have unit length; otherwise they are a normal. Colors are
/// dropped. Empty lines and text after # are skipped.
#pragma once

#include "io/streams/source.h"
#include "transformesh/document.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// True if the first line contains three or six numbers. An OFF file without its keyword starts in
/// the same way, but is detected by its extension .off.
bool is_point_text(const Source& source);

/// Throws InputError, stating the reason, if the first line holds only numbers and commas but is
/// not a point.
void check_point_text(const Source& source);

/// Reads a mesh without faces. If lines have six numbers, vertices have the columns nx ny nz.
/// Non-finite points are dropped and non-finite normals become 0, with a note, as in read_mesh().
/// Throws InputError, with the line number, for lines of different lengths and for anything else.
ReadResult read_point_text(const Source& source);

}  // namespace transformesh
