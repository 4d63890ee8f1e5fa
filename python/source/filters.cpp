/// Binds clean, stitch, repair, cat, boolean, displace, offset, shape and intersect.
#include "advice.h"
#include "arguments.h"
#include "boolean/boolean_documents.h"
#include "call.h"
#include "io/comments.h"
#include "python_mesh.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/clean.h"
#include "transformesh/displace.h"
#include "transformesh/document.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/offset.h"
#include "transformesh/repair.h"
#include "transformesh/shapes.h"
#include "transformesh/stitch.h"
#include "transformesh/velocity.h"

namespace transformesh::python {
namespace {

// --- clean, stitch, repair, cat ------------------------------------------------------------------

MeshPointer clean_mesh(const PythonMesh& mesh, int winding_level, bool outermost, bool merge_flat,
                       const std::string& method, const PythonLength& separate_by,
                       const py::object& box, bool only, bool refuse, bool source, bool source_face,
                       const py::object& progress) {
  Document document = mesh.document;
  CleanOptions options;
  options.winding_level = winding_level;
  options.outermost = outermost;
  options.merge_flat = merge_flat;
  options.refuse = refuse;
  if (choice("method", method, {"grow", "static"}) == 1)
    options.method = ExteriorMethod::static_test;
  options.coordinate = document.style.coordinate;
  options.separate = Lengths(document)(separate_by);
  if (!box.is_none()) options.box = box_of(box);
  options.only = only;
  options.sources = source        ? CleanSources::points
                    : source_face ? CleanSources::faces
                                  : CleanSources::none;
  CleanResult result =
      without_lock(progress, [&](const Progress& to) { return clean(document.mesh, options, to); });
  document.mesh = std::move(result.mesh);
  add_planarity(document.style.comments, result.merge_displacement);
  Entries report = entries_of(result);
  if (box.is_none()) return mesh_of(std::move(document), report);
  append(report, {{"box_faces", result.box_faces}, {"whole_mesh", result.is_whole}});
  return mesh_of(std::move(document), report);
}

MeshPointer stitch_mesh(const PythonMesh& mesh, const PythonLength& tolerance, bool orient,
                        bool drop_copies, bool one_side, bool outwards, bool flip) {
  Document document = mesh.document;
  const StitchOptions options{
      Lengths(document)(tolerance), orient, drop_copies, one_side, outwards, flip};
  const StitchResult result =
      without_lock(py::none(), [&](const Progress&) { return stitch(document.mesh, options); });
  return mesh_of(std::move(document), entries_of(result));
}

MeshPointer repair_mesh(const PythonMesh& mesh, bool keep_open,
                        const std::optional<PythonLength>& max_change, const py::object& progress) {
  Document document = mesh.document;
  RepairOptions options;
  options.keep_open = keep_open;
  options.max_change = Lengths(document)(max_change, options.max_change);
  options.coordinate = document.style.coordinate;
  RepairResult result = without_lock(
      progress, [&](const Progress& to) { return repair(document.mesh, options, to); });
  document.mesh = std::move(result.mesh);
  return mesh_of(std::move(document), entries_of(result));
}

MeshPointer cat(const py::args& meshes) {
  if (meshes.empty()) throw UsageError("cat: at least one mesh is needed");
  Document all = py::cast<const PythonMesh&>(meshes[0]).document;
  for (std::size_t i = 1; i < meshes.size(); ++i)
    for (const std::string& note : append(all, py::cast<const PythonMesh&>(meshes[i]).document))
      if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
  return mesh_of(std::move(all));
}

MeshPointer boolean_of(const std::string& operation, const py::args& meshes, bool inside, bool cap,
                       bool merge_flat, bool source_operand, const py::object& progress) {
  choice("operation", operation, {"union", "intersection", "difference", "xor", "cut"});
  if ((inside || cap) && operation != cut_command())
    throw UsageError(std::string(inside ? "inside" : "cap") + " can be used only with cut");
  if (meshes.empty()) throw UsageError("boolean: at least one mesh is needed");
  std::vector<Document> documents;
  std::vector<std::string> names;
  for (const auto& mesh : meshes) {
    documents.push_back(py::cast<const PythonMesh&>(mesh).document);
    names.push_back("mesh " + std::to_string(names.size()));
  }
  const SheetSide side = inside ? SheetSide::inside : SheetSide::outside;
  const DocumentsBoolean combined = without_lock(progress, [&](const Progress& to) {
    BooleanOptions options{merge_flat, source_operand};
    options.cap = cap;
    return combine_documents(operation, side, documents, names, options, to);
  });
  warn(with_advice(combined.problems));
  warn(combined.notes);
  Entries report{{"operands", names.size()}};
  append(report, entries_of(combined.result));
  return mesh_of(std::move(documents[0]), report);
}

// --- displace, offset, shape ---------------------------------------------------------------------

MeshPointer displace_mesh(const PythonMesh& mesh, const std::optional<py::array>& velocities,
                          const std::optional<PythonLength>& normal_speed, double curvature_speed,
                          double time_step, double alpha, const std::string& mask,
                          const std::optional<MeshPointer>& keep_out,
                          const std::optional<PythonLength>& gap) {
  Document document = mesh.document;
  Lengths lengths(document);
  VelocityOptions velocity;
  if (velocities) velocity.given = vectors_of(*velocities, "velocities");
  if (normal_speed) velocity.normal_speed = lengths(*normal_speed);
  velocity.curvature_speed = curvature_speed;
  velocity.mask = mask;
  const std::vector<Vec3> sum = velocities_of(document.mesh, velocity);
  const DisplaceOptions options{time_step, alpha, keep_out_of(keep_out, gap, lengths),
                                document.style.coordinate};
  const DisplaceResult result = without_lock(
      py::none(), [&](const Progress&) { return displace(document.mesh, sum, options); });
  if (result.clamped > 0)
    warn({counted(result.clamped, "vertex") + " clamped to " + shortest_text(alpha) +
          " of the mean edge at the vertex; use a smaller time_step, or a larger alpha"});
  Entries report = entries_of(result);
  report.emplace_back("held_back", result.held_back);
  return mesh_of(std::move(document), report);
}

MeshPointer offset_mesh(const PythonMesh& mesh, const PythonLength& distance,
                        const std::optional<PythonLength>& edge, std::size_t iterations, bool miter,
                        const py::object& progress) {
  Document document = mesh.document;
  const std::size_t joined = join_places(document.mesh);
  Lengths lengths(document);
  if (miter) {
    const double length = lengths(distance);
    without_lock(progress, [&](const Progress& to) {
      offset_mitered(document.mesh, length, document.style.coordinate, to);
      return true;
    });
    return mesh_of(std::move(document), Entries{{"joined_vertices", joined}});
  }
  const OffsetOptions options{lengths(distance), lengths(edge, 0), iterations};
  const OffsetResult result =
      without_lock(progress, [&](const Progress& to) { return offset(document, options, to); });
  Entries report{{"joined_vertices", joined}, {"converged", result.is_done()}};
  append(report, entries_of(result));
  return mesh_of(std::move(document), report);
}

MeshPointer shape(const std::string& kind, const py::args& parameters, const py::kwargs& given) {
  ShapeOptions options;
  options.kind = kind;
  for (const py::handle& parameter : parameters) options.parameters.push_back(py::str(parameter));
  for (const auto& [key, value] : given) {
    const std::string name = py::str(key);
    if (name == "faces")
      options.faces = py::cast<std::size_t>(value);
    else if (name == "edge")
      options.edge = py::cast<double>(value);
    else if (name == "radius")
      options.radius = py::cast<double>(value);
    else if (name == "tube")
      options.tube = py::cast<double>(value);
    else if (name == "gap")
      options.gap = py::cast<double>(value);
    else if (name == "neck")
      options.neck = py::cast<double>(value);
    else if (name == "count")
      options.count = py::cast<std::size_t>(value);
    else if (name == "noise")
      options.noise = py::cast<double>(value);
    else if (name == "seed")
      options.seed = py::cast<std::uint64_t>(value);
    else if (name == "around")
      options.around = bounding_box(py::cast<const PythonMesh&>(value).document.mesh);
    else if (name == "of")
      options.points = py::cast<const PythonMesh&>(value).document.mesh.positions;
    else
      throw UsageError("shape: there is no '" + name + "'");
  }
  Document document;
  document.mesh =
      without_lock(py::none(), [&](const Progress& to) { return make_shape(options, to); });
  return mesh_of(std::move(document));
}

// --- intersect -----------------------------------------------------------------------------------

py::array intersect(const PythonMesh& mesh, const py::object& progress) {
  const std::vector<FacePair> pairs = without_lock(
      progress, [&](const Progress& to) { return find_intersections(mesh.document.mesh, to); });
  py::array_t<Index> array({pairs.size(), std::size_t{2}});
  auto rows = array.mutable_unchecked<2>();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    rows(static_cast<py::ssize_t>(i), 0) = pairs[i].first;
    rows(static_cast<py::ssize_t>(i), 1) = pairs[i].second;
  }
  return array;
}

}  // namespace

void bind_filters(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  module.def(
      "clean", &clean_mesh, arg("mesh"), py::kw_only(), arg("level") = 1, arg("outermost") = false,
      arg("merge_flat") = false, arg("method") = "grow", arg("separate") = PythonLength(0.0),
      arg("box") = none, arg("only") = false, arg("refuse") = false, arg("source") = false,
      arg("source_face") = false, arg("progress") = none,
      "Removes self-intersections: the boundary of winding number at least `level`, exactly, "
      "closed, manifold, without a self-intersection in the numbers as written. 2 intersects two "
      "bodies. `outermost` drops cavities and what floats in them. `merge_flat` covers flat "
      "regions with few triangles where faces were cut. In a `box` ((x, y, z), (x, y, z)) what "
      "intersects there is resolved and all else left, or with `only` left out. `source` writes "
      "where on the input each vertex comes from, for carry(), "
      "`source_face` the input face of each face. See tm-clean(1).");
  module.def("stitch", &stitch_mesh, arg("mesh"), py::kw_only(),
             arg("tolerance") = PythonLength(0.0), arg("orient") = false,
             arg("drop_copies") = false, arg("one_side") = false, arg("outwards") = false,
             arg("flip") = false,
             "Joins a soup of triangles into a manifold mesh; turns and reverses faces. See "
             "tm-stitch(1).");
  module.def("repair", &repair_mesh, arg("mesh"), py::kw_only(), arg("keep_open") = false,
             arg("max_change") = none, arg("progress") = none,
             "Makes a solid of any mesh by the least change; the report has each step, its place, "
             "and how much area and volume changed. See tm-repair(1).");
  module.def("cat", &cat, "Concatenates meshes.");
  module.def(
      "boolean", &boolean_of, arg("operation"), arg("inside") = false, arg("cap") = false,
      arg("merge_flat") = true, arg("source_operand") = false, arg("progress") = none,
      "Combines solids, each by its own winding number: 'union', 'intersection', "
      "'difference', 'xor', or 'cut' for the part of a sheet outside a solid, `inside` for "
      "that inside it, and `cap` to close it with faces of the solid. `source_operand` writes "
      "the number of the mesh that each face comes from. See tm-boolean(1).");
  module.def("displace", &displace_mesh, arg("mesh"), arg("velocities") = none, py::kw_only(),
             arg("normal_speed") = none, arg("curvature_speed") = 0.0, arg("time_step") = 1.0,
             arg("alpha") = DisplaceOptions().alpha, arg("mask") = "", arg("keep_out") = none,
             arg("gap") = none,
             "Moves vertices by velocities (n, 3), or by the columns vx vy vz, by no more than "
             "alpha times the mean edge at each, and no nearer than `gap` to the mesh `keep_out`. "
             "`mask` is a column by which velocities are multiplied. See tm-displace(1).");
  module.def("offset", &offset_mesh, arg("mesh"), arg("distance"), py::kw_only(),
             arg("edge") = none, arg("iterations") = OffsetOptions().iterations,
             arg("miter") = false, arg("progress") = none,
             "The surface at a distance, outwards or inwards where negative; `miter` keeps corners "
             "sharp. See tm-offset(1).");
  module.def("shape", &shape, arg("kind"),
             "Makes a closed mesh: shape('genus', 3, faces=4000). See tm-shape(1).");
  module.def("intersect", &intersect, arg("mesh"), py::kw_only(), arg("progress") = none,
             "The pairs of faces that intersect, as an array (k, 2).");
}

}  // namespace transformesh::python
