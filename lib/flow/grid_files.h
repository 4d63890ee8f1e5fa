/// Files of grids: VTK ImageData and NRRD.
#pragma once

#include "io/streams/source.h"
#include "transformesh/flow.h"

namespace transformesh {

/// Reads ImageData of VTK's XML format in one piece (docs.vtk.org, "VTK XML Formats"). Values are
/// the active vectors or scalars of PointData, or the only array with so many components. Without
/// such an array, those of CellData count at the centers of cells. The field TimeValue is the time.
/// Throws InputError.
FlowGrid read_vti_grid(const Source& source, std::size_t components);

/// Reads NRRD (teem.sourceforge.net/nrrd/format.html) with its data in the same file and raw, as
/// float or double, with axes along x, y and z. The key `time` is the time. Throws InputError.
FlowGrid read_nrrd_grid(const Source& source, std::size_t components);

/// Reads the files of `where` (file_list.h) for a flow: speeds for `normal`, velocities for any
/// other flow. A `step` above 0 is the time from a file to the next, instead of the times that they
/// state. Nothing if `where` is empty. Throws UsageError for a step without files.
std::vector<FlowGrid> read_flow_grids(const std::string& flow, const std::string& where,
                                      double step);

/// True if the bytes start as NRRD does.
bool is_nrrd(std::string_view bytes);

}  // namespace transformesh
