/// Binds flow, which computes velocities of a named flow.
#include "arguments.h"
#include "call.h"
#include "entries/entries.h"
#include "flow/flow_columns.h"
#include "flow/flow_notes.h"
#include "flow/grid_files.h"
#include "python_mesh.h"
#include "transformesh/flow.h"

namespace transformesh::python {
namespace {

MeshPointer flow_of(const PythonMesh& mesh, const std::string& name, double time, double span,
                    double speed, const std::optional<double>& period, const py::object& center,
                    const py::object& direction, const std::optional<std::string>& column,
                    const std::string& grid, double grid_step, const py::object& progress) {
  Document document = mesh.document;
  FlowOptions options{speed, period, optional_vector(center, "center"),
                      optional_vector(direction, "direction"), column};
  Flow flow;
  const FlowSpeeds speeds = without_lock(progress, [&](const Progress& to) {
    options.grids = read_flow_grids(name, grid, grid_step);
    flow = make_flow(name, options);
    return add_flow_columns(document.mesh, flow.motion, {time, span}, to);
  });
  warn(notes_of(*flow.counts));
  Entries report = entries_of(speeds);
  append(report, entries_of(*flow.counts));
  return mesh_of(std::move(document), report);
}

}  // namespace

void bind_flows(py::module_& module) {
  using py::arg;
  const py::none none;
  module.def("flow", &flow_of, arg("mesh"), arg("name"), py::kw_only(), arg("time") = 0.0,
             arg("span") = 0.0, arg("speed") = 1.0, arg("period") = none, arg("center") = none,
             arg("direction") = none, arg("column") = none, arg("grid") = "",
             arg("grid_step") = 0.0, arg("progress") = none,
             "The mesh with the velocities of a flow as its columns vx vy vz: 'deformation', "
             "'mean-curvature' and others. `grid` names a file, a folder or a pattern. See "
             "tm-flow(1).");
}

}  // namespace transformesh::python
