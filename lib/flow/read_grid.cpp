#include <cmath>

#include "flow/grid_files.h"
#include "io/formats/vtk_xml.h"
#include "io/streams/file_list.h"
#include "transformesh/flow.h"

namespace transformesh {
namespace {

void check_values(const Source& source, const FlowGrid& grid) {
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    if (!std::isfinite(grid.values[i]))
      source.fail("a value of node " + std::to_string(i / grid.components) +
                  " of the grid is not a finite number");
  if (!grid.origin.allFinite() || !grid.spacing.allFinite() || !(grid.spacing.minCoeff() > 0))
    source.fail("the spacing of the grid must be above 0 along each axis");
}

}  // namespace

FlowGrid read_flow_grid(std::string_view bytes, const std::string& name, std::size_t components) {
  const Source source{bytes, name};
  if (bytes.empty()) source.fail("the grid file is empty");
  if (!is_nrrd(bytes) && !is_vtk_xml(bytes))
    source.fail("the file is neither VTK ImageData (.vti) nor NRRD");
  FlowGrid grid =
      is_nrrd(bytes) ? read_nrrd_grid(source, components) : read_vti_grid(source, components);
  check_values(source, grid);
  return grid;
}

std::vector<FlowGrid> read_flow_grids(const std::string& flow, const std::string& where,
                                      double step) {
  std::vector<FlowGrid> grids;
  if (!(step >= 0)) throw UsageError("the time between consecutive grids must be above 0");
  if (where.empty() && step > 0)
    throw UsageError("a time between consecutive grids is given, but no grids");
  if (where.empty()) return grids;
  for (const std::string& file : files_at(where)) {
    grids.push_back(read_flow_grid(file_bytes(file), file, flow == "normal" ? 1 : 3));
    if (step > 0) grids.back().time = step * static_cast<double>(grids.size() - 1);
  }
  return grids;
}

}  // namespace transformesh
