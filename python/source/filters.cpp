/// Binds clean, stitch, repair, cat, boolean, displace, offset, thicken, shape, flow and intersect.
#include "advice.h"
#include "boolean/boolean_documents.h"
#include "call.h"
#include "flow/flow_columns.h"
#include "flow/flow_notes.h"
#include "flow/grid_files.h"
#include "io/comments.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/clean.h"
#include "transformesh/displace.h"
#include "transformesh/flow.h"
#include "transformesh/intersect.h"
#include "transformesh/offset.h"
#include "transformesh/repair.h"
#include "transformesh/shapes.h"
#include "transformesh/stitch.h"
#include "transformesh/velocity.h"

namespace transformesh::python {
namespace {

// --- clean, stitch, repair, cat ------------------------------------------------------------------

MeshPointer clean_mesh(Call& call) {
  CleanOptions options;
  call("level", options.winding_level)("outermost", options.outermost)(
      "merge_flat", options.merge_flat)("refuse", options.refuse)("only", options.only);
  options.method = call.choice<ExteriorMethod>(
      "method", {{"grow", ExteriorMethod::grow}, {"static", ExteriorMethod::static_test}});
  options.coordinate = call.document.style.coordinate;
  options.separate = call.length("separate");
  options.box = call.box();
  options.sources = call.get<bool>("source")        ? CleanSources::points
                    : call.get<bool>("source_face") ? CleanSources::faces
                                                    : CleanSources::none;
  CleanResult result =
      call.run([&](const Progress& to) { return clean(call.document.mesh, options, to); });
  call.document.mesh = std::move(result.mesh);
  add_planarity(call.document.style.comments, result.merge_displacement);
  call.report = entries_of(result);
  if (!options.box) return call.result();
  return call.result({{"box_faces", result.box_faces}, {"whole_mesh", result.is_whole}});
}

MeshPointer stitch_mesh(Call& call) {
  StitchOptions options;
  options.tolerance = call.length("tolerance");
  call("orient", options.orient)("drop_copies", options.drop_copies)("one_side", options.one_side)(
      "outwards", options.outwards)("flip", options.flip);
  return call.result(
      entries_of(call.run([&](const Progress&) { return stitch(call.document.mesh, options); })));
}

MeshPointer repair_mesh(Call& call) {
  RepairOptions options;
  call("keep_open", options.keep_open);
  options.max_change = call.length("max_change", options.max_change);
  options.coordinate = call.document.style.coordinate;
  RepairResult result =
      call.run([&](const Progress& to) { return repair(call.document.mesh, options, to); });
  call.document.mesh = std::move(result.mesh);
  return call.result(entries_of(result));
}

MeshPointer cat(Call& call) {
  const std::vector<const PythonMesh*> meshes = call.meshes("cat");
  call.document = meshes[0]->document;
  for (std::size_t i = 1; i < meshes.size(); ++i) warn(append(call.document, meshes[i]->document));
  return call.result();
}

MeshPointer boolean_of(Call& call) {
  const std::string operation = call.word("operation", boolean_commands());
  BooleanOptions options;
  call("merge_flat", options.merge_flat)("cap", options.cap);
  call("source_operand", options.source_operand);
  const auto inside = call.get<bool>("inside");
  if ((inside || options.cap) && operation != cut_command())
    throw UsageError(std::string(inside ? "inside" : "cap") + " can be used only with cut");
  std::vector<Document> documents;
  std::vector<std::string> names;
  for (const PythonMesh* mesh : call.meshes("boolean")) {
    documents.push_back(mesh->document);
    names.push_back("mesh " + std::to_string(names.size()));
  }
  const SheetSide side = inside ? SheetSide::inside : SheetSide::outside;
  const DocumentsBoolean combined = call.run([&](const Progress& to) {
    return combine_documents(operation, side, documents, names, options, to);
  });
  warn(with_advice(combined.problems));
  warn(combined.notes);
  call.document = std::move(documents[0]);
  call.report = {{"operands", names.size()}};
  return call.result(entries_of(combined.result));
}

// --- displace, offset, thicken, shape, flow ------------------------------------------------------

MeshPointer displace_mesh(Call& call) {
  VelocityOptions velocity;
  if (const py::object given = call["velocities"]; !given.is_none())
    velocity.given = vectors_of(py::array::ensure(given), "velocities");
  if (!call["normal_speed"].is_none()) velocity.normal_speed = call.length("normal_speed");
  call("curvature_speed", velocity.curvature_speed)("mask", velocity.mask);
  const std::vector<Vec3> sum = velocities_of(call.document.mesh, velocity);
  DisplaceOptions options;
  call("time_step", options.time_step)("alpha", options.alpha);
  options.keep_out = call.keep_out();
  options.coordinate = call.document.style.coordinate;
  const DisplaceResult result =
      call.run([&](const Progress&) { return displace(call.document.mesh, sum, options); });
  if (result.clamped > 0)
    warn({counted(result.clamped, "vertex") + " clamped to " + shortest_text(options.alpha) +
          " of the mean edge at the vertex; use a smaller time_step, or a larger alpha"});
  call.report = entries_of(result);
  return call.result({{"held_back", result.held_back}});
}

MeshPointer offset_mesh(Call& call) {
  call.join();
  OffsetOptions options;
  options.distance = call.length("distance");
  if (call.get<bool>("miter")) {
    call.run([&](const Progress& to) {
      offset_mitered(call.document.mesh, options.distance, call.document.style.coordinate, to);
      return true;
    });
    return call.result();
  }
  options.edge = call.length("edge");
  call("iterations", options.iterations);
  const OffsetResult result =
      call.run([&](const Progress& to) { return offset(call.document, options, to); });
  call.report.emplace_back("converged", result.is_done());
  return call.result(entries_of(result));
}

MeshPointer thicken_mesh(Call& call) {
  join_places(call.document.mesh);
  const double thickness = call.length("thickness");
  call.run([&](const Progress& to) {
    thicken(call.document.mesh, thickness, call.document.style.coordinate, to);
    return true;
  });
  return call.result();
}

MeshPointer shape(Call& call) {
  ShapeOptions options;
  call("kind", options.kind);
  for (const py::handle& parameter : call.get<py::tuple>("parameters"))
    options.parameters.push_back(py::str(parameter));
  const Call given(call.get<py::kwargs>("options"));
  for (const auto& [key, value] : call.get<py::dict>("options")) {
    const std::string name = py::str(key);
    const auto set = [&](const char* known, auto& member) {
      if (name == known) given(known, member);
      return name == known;
    };
    if (set("faces", options.faces) || set("edge", options.edge) || set("radius", options.radius) ||
        set("tube", options.tube) || set("gap", options.gap) || set("neck", options.neck) ||
        set("count", options.count) || set("noise", options.noise) || set("seed", options.seed))
      continue;
    if (name == "around")
      options.around = bounding_box(given.mesh("around").document.mesh);
    else if (name == "of")
      options.points = given.mesh("of").document.mesh.positions;
    else
      throw UsageError("shape: there is no '" + name + "'");
  }
  return mesh_of(call.run([&](const Progress& to) { return make_shape(options, to); }));
}

MeshPointer flow_of(Call& call) {
  FlowOptions options;
  call("speed", options.speed)("period", options.period)("column", options.column);
  options.center = call.vector("center");
  options.direction = call.vector("direction");
  const auto name = call.get<std::string>("name");
  const auto grid = call.get<std::string>("grid");
  const auto grid_step = call.get<double>("grid_step");
  const Moment moment{call.get<double>("time"), call.get<double>("span")};
  Flow flow;
  const FlowSpeeds speeds = call.run([&](const Progress& to) {
    options.grids = read_flow_grids(name, grid, grid_step);
    flow = make_flow(name, options);
    return add_flow_columns(call.document.mesh, flow.motion, moment, to);
  });
  warn(notes_of(*flow.counts));
  call.report = entries_of(speeds);
  return call.result(entries_of(*flow.counts));
}

// --- intersect -----------------------------------------------------------------------------------

py::array intersect(Call& call) {
  const Mesh& mesh = call.mesh("mesh").document.mesh;
  const std::vector<FacePair> pairs =
      call.run([&](const Progress& to) { return find_intersections(mesh, to); });
  py::array_t<Index> array({pairs.size(), std::size_t{2}});
  Index* to = array.mutable_data();
  for (const auto& [first, second] : pairs) {
    *to++ = first;
    *to++ = second;
  }
  return array;
}

}  // namespace

void bind_filters(py::module_& module) {
  define_filter(module, "clean", &clean_mesh);
  define_filter(module, "stitch", &stitch_mesh);
  define_filter(module, "repair", &repair_mesh);
  define(module, "cat", &cat);
  define(module, "boolean", &boolean_of);
  define_filter(module, "displace", &displace_mesh);
  define_filter(module, "offset", &offset_mesh);
  define_filter(module, "thicken", &thicken_mesh);
  define(module, "shape", &shape);
  define_filter(module, "flow", &flow_of);
  define(module, "intersect", &intersect);
}

}  // namespace transformesh::python
