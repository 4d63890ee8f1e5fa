/// Readers of grid files: VTK ImageData and NRRD.
#pragma once

#include "io/streams/source.h"
#include "transformesh/flow.h"

namespace transformesh {

/// Reads ImageData of VTK's XML format in one piece (docs.vtk.org, "VTK XML Formats"). Values are
/// the active vectors or scalars of PointData, or the only array with `components` components. If
/// PointData has no such array, values are those of CellData, at the centers of cells. The field
/// TimeValue is the time. Throws InputError.
FlowGrid read_vti_grid(const Source& source, std::size_t components);

/// Reads NRRD (teem.sourceforge.net/nrrd/format.html). The data must be in the same file, raw,
/// float or double, with axes along x, y and z. The key `time` is the time. Throws InputError.
FlowGrid read_nrrd_grid(const Source& source, std::size_t components);

/// Reads the files in the list `where` (file_list.h): speeds for the flow `normal`, velocities for
/// all other flows. If `step` > 0, it is the time between consecutive files, and the times in the
/// files are ignored. Returns nothing if `where` is empty. Throws UsageError for a step without
/// files.
std::vector<FlowGrid> read_flow_grids(const std::string& flow, const std::string& where,
                                      double step);

/// True if the bytes start with the signature of NRRD.
bool is_nrrd(std::string_view bytes);

}  // namespace transformesh
