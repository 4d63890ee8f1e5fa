/// The legacy VTK format (The VTK User's Guide, 11th ed., "VTK File Formats"), text and binary:
/// PolyData of versions 1 to 5.1, and the polygons of unstructured grids. Read only.
#pragma once

#include "io/streams/source.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// True if the first line is that of the format.
bool is_vtk(std::string_view bytes);

/// Begins text of another format with an empty line if its first comment reads like the first line
/// of VTK.
std::string unlike_vtk(std::string text);

/// See read_mesh().
ReadResult read_vtk(const Source& source);

}  // namespace transformesh
