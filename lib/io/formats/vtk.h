/// The legacy VTK format (The VTK User's Guide, 11th ed., "VTK File Formats"), text and binary:
/// PolyData of versions 1 to 5.1, and the polygons of unstructured grids. Read only.
#pragma once

#include "io/streams/source.h"
#include "transformesh/mesh_io.h"

namespace transformesh {

/// True if the first line is the first line of the legacy VTK format.
bool is_vtk(std::string_view bytes);

/// Returns the text of another format. If its first comment resembles the first line of VTK, adds
/// an empty line before it, so that readers do not take the file for VTK.
std::string unlike_vtk(std::string text);

/// Reads VTK as read_mesh() does.
ReadResult read_vtk(const Source& source);

}  // namespace transformesh
