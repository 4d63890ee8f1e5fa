/// Point files with a header line of names, such as `x y z nx ny nz` or `X,Y,Z,R,G,B`, optionally
/// after `//`. Scanner files (.pts) instead have only the number of points in the first line.
/// Blanks, commas and semicolons separate values. Read only.
#pragma once

#include "io/streams/source.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// True if the first line is a header of names or a number of points, and the second line starts
/// with numbers.
bool is_point_table(const Source& source);

/// Reads a mesh without faces. Normals become the columns nx ny nz, colors red green blue alpha,
/// and every other name a column. If lines have no names, they must be x y z, x y z intensity, x y
/// z red green blue, or all seven. Throws InputError, with the line number, for anything else.
ReadResult read_point_table(const Source& source);

}  // namespace transformesh
