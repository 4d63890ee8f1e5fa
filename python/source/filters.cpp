/// What makes one mesh of another, as the programs of the same names do.
#include "arguments.h"
#include "call.h"
#include "clean/stitch/separate.h"
#include "geometry/source_points.h"
#include "mesh/surface_columns.h"
#include "mesh/touching_borders.h"
#include "python_mesh.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/clean_box.h"
#include "transformesh/components.h"
#include "transformesh/displace.h"
#include "transformesh/document.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/offset.h"
#include "transformesh/shapes.h"
#include "transformesh/stitch.h"
#include "transformesh/velocity.h"

namespace transformesh::python {
namespace {

// --- clean, stitch, cat --------------------------------------------------------------------------

py::dict report_of(const CleanResult& result) {
  py::dict report;
  report["changed"] = result.changed;
  report["pairs"] = result.pairs;
  report["pieces"] = result.pieces;
  report["cut_faces"] = result.cut_faces;
  report["removed_faces"] = result.removed_faces;
  report["new_vertices"] = result.new_vertices;
  report["copied_vertices"] = result.copied_vertices;
  report["dropped_components"] = result.dropped_components;
  report["rounding_places"] = result.rounding_places;
  report["rounding_faces"] = result.rounding_faces;
  report["rounding_pairs"] = result.rounding_pairs;
  report["rounding_level"] = result.rounding_level;
  report["rounding_displacement"] = result.rounding_displacement;
  report["rounding_spacings"] = result.rounding_spacings;
  return report;
}

struct CleanChoices {
  CleanOptions whole;
  std::optional<Box> box;
  bool only = false;
  double separate_by = 0;
  bool source = false, source_face = false;
};

// What the whole mesh is needed for has no meaning in a box.
void check_choices(const CleanChoices& choices) {
  if (!choices.box) {
    if (choices.only) throw UsageError("only: needs box, whose faces it leaves");
    return;
  }
  const char* const refused = choices.whole.method != ExteriorMethod::grow ? "method='static'"
                              : choices.whole.outermost                    ? "outermost"
                              : choices.separate_by != 0                   ? "separate"
                                                                           : nullptr;
  if (refused) throw UsageError(std::string(refused) + " is for whole meshes, without box");
}

constexpr const char* face_number = "tm:source-face";  // while cleaning

void number_faces(Mesh& mesh, const char* name) {
  Column& column = mesh.face_columns.get(name, Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) column.values[f] = static_cast<double>(f);
}

CleanBoxResult clean_as_asked(const Mesh& mesh, const CleanChoices& choices,
                              const Progress& progress) {
  const CleanOptions& whole = choices.whole;
  if (!choices.box) return {clean(mesh, whole, progress)};
  CleanBoxOptions options{*choices.box, choices.only};
  options.winding_level = whole.winding_level;
  options.refuse = whole.refuse;
  options.coordinate = whole.coordinate;
  return clean_box(mesh, options, progress);
}

struct Cleaned {
  CleanBoxResult result;
  SeparateResult separated;
};

Cleaned clean_document(Mesh& mesh, const CleanChoices& choices, const Progress& progress) {
  if (choices.source_face) {
    drop_source_points(mesh);
    number_faces(mesh, "source_face");
  }
  Mesh source;
  if (choices.source) {
    source = {mesh.positions, mesh.faces, {}, {}};
    number_faces(mesh, face_number);
  }
  Cleaned cleaned{clean_as_asked(mesh, choices, progress), {}};
  mesh = std::move(cleaned.result.clean.mesh);
  if (choices.separate_by > 0)
    cleaned.separated = separate(mesh, {choices.separate_by, choices.whole.coordinate}, progress);
  if (choices.whole.refuse && cleaned.separated.separated_vertices > 0)
    throw GoalError("vertices lie in one place, and refuse forbids to move them apart");
  if (choices.source) {
    const Column& numbers = *mesh.face_columns.find(face_number);
    write_source_points(mesh, source_points_of_pieces(source, mesh, numbers.values));
    mesh.face_columns.erase(face_number);
  }
  return cleaned;
}

MeshPointer clean_mesh(const PythonMesh& mesh, int winding_level, bool outermost,
                       const std::string& method, const PythonLength& separate_by,
                       const py::object& box, bool only, bool refuse, bool source, bool source_face,
                       const py::object& progress) {
  Document document = mesh.document;
  CleanChoices choices;
  choices.whole.winding_level = winding_level;
  choices.whole.outermost = outermost;
  choices.whole.refuse = refuse;
  if (choice("method", method, {"grow", "static"}) == 1)
    choices.whole.method = ExteriorMethod::static_test;
  choices.whole.coordinate = document.style.coordinate;
  if (!box.is_none()) choices.box = box_of(box);
  choices.only = only;
  choices.separate_by = Lengths(document)(separate_by);
  choices.source = source;
  choices.source_face = source_face;
  check_choices(choices);
  const Cleaned cleaned = without_lock(
      progress, [&](const Progress& to) { return clean_document(document.mesh, choices, to); });
  py::dict report = report_of(cleaned.result.clean);
  report["separated_vertices"] = cleaned.separated.separated_vertices;
  report["separation_refused"] = cleaned.separated.refused_vertices;
  if (choices.box) {
    report["box_faces"] = cleaned.result.box_faces;
    report["whole_mesh"] = cleaned.result.is_whole;
  }
  return mesh_of(std::move(document), report);
}

MeshPointer stitch_mesh(const PythonMesh& mesh, const PythonLength& tolerance, bool orient,
                        bool one_side, bool flip) {
  Document document = mesh.document;
  const StitchOptions options{Lengths(document)(tolerance), orient, one_side, flip};
  const StitchResult result =
      without_lock(py::none(), [&](const Progress&) { return stitch(document.mesh, options); });
  py::dict report;
  report["joined_vertices"] = result.joined_vertices;
  report["copied_vertices"] = result.copied_vertices;
  report["split_edges"] = result.split_edges;
  report["dropped_faces"] = result.dropped_faces;
  report["dropped_reverses"] = result.dropped_reverses;
  report["turned_faces"] = result.reversed_faces;
  report["misoriented_edges"] = result.misoriented_edges;
  report["border_edges"] = result.border_edges;
  return mesh_of(std::move(document), report);
}

MeshPointer cat(const py::args& meshes) {
  if (meshes.empty()) throw UsageError("cat: at least one mesh is needed");
  Document all = py::cast<const PythonMesh&>(meshes[0]).document;
  for (std::size_t i = 1; i < meshes.size(); ++i)
    for (const std::string& note : append(all, py::cast<const PythonMesh&>(meshes[i]).document))
      if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
  return mesh_of(std::move(all));
}

// --- displace, offset, shape ---------------------------------------------------------------------

void add(std::vector<Vec3>& velocities, const std::vector<Vec3>& more) {
  for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v] += more[v];
}

MeshPointer displace_mesh(const PythonMesh& mesh, const std::optional<py::array>& velocities,
                          const std::optional<PythonLength>& normal_speed, double curvature_speed,
                          double time_step, double alpha, const std::string& mask,
                          const std::optional<MeshPointer>& keep_out,
                          const std::optional<PythonLength>& gap) {
  Document document = mesh.document;
  Lengths lengths(document);
  const Mesh& moving = document.mesh;
  const bool has_speed = velocities || normal_speed || curvature_speed != 0;
  std::vector<Vec3> sum(moving.positions.size(), Vec3::Zero());
  if (velocities) {
    sum = vectors_of(*velocities, "velocities");
  } else if (!has_speed || has_column_velocities(moving)) {
    sum = column_velocities(moving);
  }
  if (normal_speed || curvature_speed != 0) refuse_touching_borders(moving);
  if (normal_speed) add(sum, normal_velocities(moving, lengths(*normal_speed)));
  if (curvature_speed != 0) add(sum, curvature_velocities(moving, curvature_speed));
  if (!mask.empty()) apply_mask(moving, mask, sum);
  const DisplaceOptions options{time_step, alpha, keep_out_of(keep_out, gap, lengths),
                                document.style.coordinate};
  const DisplaceResult result = without_lock(
      py::none(), [&](const Progress&) { return displace(document.mesh, sum, options); });
  if (result.clamped > 0)
    warn({counted(result.clamped, "vertex") + " clamped to " + shortest_text(alpha) +
          " of the mean edge at the vertex; use a smaller time_step, or a larger alpha"});
  py::dict report;
  report["moved"] = result.moved;
  report["clamped"] = result.clamped;
  report["held_back"] = result.held_back;
  report["max_displacement"] = result.max_displacement;
  report["rms_displacement"] = result.rms_displacement;
  report["mean_edge"] = result.mean_edge;
  return mesh_of(std::move(document), report);
}

MeshPointer offset_mesh(const PythonMesh& mesh, const PythonLength& distance,
                        const std::optional<PythonLength>& edge, std::size_t iterations,
                        const py::object& progress) {
  Document document = mesh.document;
  const std::size_t joined = join_places(document.mesh);
  Lengths lengths(document);
  const OffsetOptions options{lengths(distance), lengths(edge, 0), iterations};
  const OffsetResult result =
      without_lock(progress, [&](const Progress& to) { return offset(document, options, to); });
  py::dict report;
  report["joined_vertices"] = joined;
  report["converged"] = result.is_done();
  report["iterations"] = result.iterations;
  report["components"] = result.topology.components;
  report["genus"] = result.topology.genus;
  report["deviation_rms"] = result.deviation.rms;
  report["deviation_max"] = result.deviation.most;
  report["missed_max"] = result.deviation.missed;
  report["edge"] = result.edge;
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
      arg("method") = "grow", arg("separate") = PythonLength(0.0), arg("box") = none,
      arg("only") = false, arg("refuse") = false, arg("source") = false, arg("source_face") = false,
      arg("progress") = none,
      "Removes self-intersections: the boundary of winding number at least `level`, exactly, "
      "closed, manifold, without a self-intersection in the numbers as written. 2 intersects two "
      "bodies. `outermost` drops cavities and what floats in them. In a `box` ((x, y, z), "
      "(x, y, z)) what intersects there is resolved and all else left, or with `only` left "
      "out. `source` writes where on the input each vertex comes from, for carry(), "
      "`source_face` the input face of each face. See tm-clean(1).");
  module.def("stitch", &stitch_mesh, arg("mesh"), py::kw_only(),
             arg("tolerance") = PythonLength(0.0), arg("orient") = false, arg("one_side") = false,
             arg("flip") = false,
             "Joins a soup of triangles into a manifold mesh; turns and reverses faces. See "
             "tm-stitch(1).");
  module.def("cat", &cat, "Concatenates meshes.");
  module.def("displace", &displace_mesh, arg("mesh"), arg("velocities") = none, py::kw_only(),
             arg("normal_speed") = none, arg("curvature_speed") = 0.0, arg("time_step") = 1.0,
             arg("alpha") = DisplaceOptions().alpha, arg("mask") = "", arg("keep_out") = none,
             arg("gap") = none,
             "Moves vertices by velocities (n, 3), or by the columns vx vy vz, by no more than "
             "alpha times the mean edge at each, and no nearer than `gap` to the mesh `keep_out`. "
             "`mask` is a column by which velocities are multiplied. See tm-displace(1).");
  module.def("offset", &offset_mesh, arg("mesh"), arg("distance"), py::kw_only(),
             arg("edge") = none, arg("iterations") = OffsetOptions().iterations,
             arg("progress") = none,
             "The surface at a distance, outwards or inwards where negative. See tm-offset(1).");
  module.def("shape", &shape, arg("kind"),
             "Makes a closed mesh: shape('genus', 3, faces=4000). See tm-shape(1).");
  module.def("intersect", &intersect, arg("mesh"), py::kw_only(), arg("progress") = none,
             "The pairs of faces that intersect, as an array (k, 2).");
}

}  // namespace transformesh::python
