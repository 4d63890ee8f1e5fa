/// What makes one mesh of another, as the programs of the same names do.
#include "call.h"
#include "python_mesh.h"
#include "tm/clean/clean.h"
#include "tm/clean/intersect/intersect.h"
#include "tm/clean/stitch/separate.h"
#include "tm/clean/stitch/stitch.h"
#include "tm/evolution/offset.h"
#include "tm/io/concatenate.h"
#include "tm/mesh/components.h"
#include "tm/remesh/decimate.h"
#include "tm/remesh/remesh.h"
#include "tm/shapes/shapes.h"
#include "tm/step/displace.h"
#include "tm/step/velocity.h"
#include "tm/support/error.h"

namespace transformesh::python {
namespace {

/// One of the words, by its place.
std::size_t choice(const std::string& name, const std::string& word,
                   std::initializer_list<const char*> words) {
  std::string list;
  std::size_t place = 0;
  for (const char* known : words) {
    if (word == known) return place;
    list += (place++ == 0 ? "" : ", ") + std::string(known);
  }
  throw UsageError(name + ": '" + word + "' is none of " + list);
}

// --- clean, stitch, cat --------------------------------------------------------------------------

py::dict report_of(const CleanResult& result) {
  py::dict report;
  report["changed"] = result.changed;
  report["pairs"] = result.pairs;
  report["cut_faces"] = result.cut_faces;
  report["removed_faces"] = result.removed_faces;
  report["new_vertices"] = result.new_vertices;
  report["copied_vertices"] = result.copied_vertices;
  report["dropped_components"] = result.dropped_components;
  report["rounding_places"] = result.rounding_places;
  report["rounding_displacement"] = result.rounding_displacement;
  report["rounding_spacings"] = result.rounding_spacings;
  return report;
}

MeshPointer clean_mesh(const PythonMesh& mesh, int level, bool outermost, const std::string& method,
                       const PythonLength& separate_by, bool refuse, const py::object& progress) {
  Document document = mesh.document;
  CleanOptions options;
  options.level = level;
  options.outermost = outermost;
  options.refuse = refuse;
  if (choice("method", method, {"grow", "static"}) == 1)
    options.method = ExteriorMethod::static_test;
  options.coordinate = document.style.coordinate;
  const double distance = Lengths(document)(separate_by);
  CleanResult result = without_lock(progress, [&](const Progress& to) {
    CleanResult cleaned = clean(document.mesh, options, to);
    document.mesh = std::move(cleaned.mesh);
    if (distance > 0) separate(document.mesh, {distance, options.coordinate}, to);
    return cleaned;
  });
  return mesh_of(std::move(document), report_of(result));
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

// --- remesh --------------------------------------------------------------------------------------

using SmoothingChoice = std::variant<double, std::string>;

void set_smoothing(const SmoothingChoice& smooth, RemeshOptions& options) {
  if (const auto* factor = std::get_if<double>(&smooth)) {
    options.smoothing = Smoothing::laplace;
    options.smooth_first = *factor;
  } else if (choice("smooth", std::get<std::string>(smooth), {"tangential", "none"}) == 1) {
    options.smoothing = Smoothing::none;
  }
}

struct RemeshChoices {
  std::optional<PythonLength> min_edge, max_edge, adaptive;
  std::string size_field;
  SmoothingChoice smooth;
  std::string flip, only;
};

/// As tm-remesh does: relative lengths are of the reference edge, or of the local size.
RemeshOptions remesh_options(const RemeshChoices& choices, Document& document) {
  RemeshOptions options;
  Lengths lengths(document);
  const bool adapts = choices.adaptive.has_value();
  if (adapts) options.adaptive_error = lengths(*choices.adaptive);
  options.size_column = choices.size_field;
  const auto edge = [&](const std::optional<PythonLength>& length, const char* otherwise) {
    const PythonLength asked = length.value_or(otherwise);
    if (choices.size_field.empty()) return lengths(asked);
    const Length factor = parsed(asked);
    if (factor.unit == Length::Unit::reference_edge) return factor.value;
    throw UsageError("with size_field, min_edge and max_edge are factors of it such as '0.7x'");
  };
  options.min_edge = edge(choices.min_edge, adapts ? "0.1x" : "0.7x");
  options.max_edge = edge(choices.max_edge, adapts ? "5x" : "1.5x");
  set_smoothing(choices.smooth, options);
  const std::size_t flip = choice("flip", choices.flip, {"valence", "angle", "none"});
  options.flip = flip == 0 ? FlipRule::valence : flip == 1 ? FlipRule::angle : FlipRule::none;
  options.only_smooth = choice("only", choices.only, {"all", "smooth"}) == 1;
  options.coordinate = document.style.coordinate;
  return options;
}

py::dict report_of(const RemeshResult& result) {
  py::dict report;
  report["splits"] = result.splits;
  report["collapses"] = result.collapses;
  report["flips"] = result.flips;
  report["refused"] = result.refused;
  report["components_removed"] = result.components_removed;
  report["degenerate_faces"] = result.degenerate_faces;
  return report;
}

MeshPointer remesh_mesh(const PythonMesh& mesh, std::optional<PythonLength> min_edge,
                        std::optional<PythonLength> max_edge, std::optional<PythonLength> adaptive,
                        const std::string& size_field, int iterations,
                        const SmoothingChoice& smooth, const std::string& flip,
                        const std::string& only, double feature_angle, bool keep_border,
                        bool project, const py::object& progress) {
  Document document = mesh.document;
  RemeshOptions options =
      remesh_options({min_edge, max_edge, adaptive, size_field, smooth, flip, only}, document);
  options.iterations = iterations;
  options.feature_angle_deg = feature_angle;
  options.keep_border = keep_border;
  options.project = project;
  const RemeshResult result = without_lock(
      progress, [&](const Progress& to) { return remesh(document.mesh, options, to); });
  return mesh_of(std::move(document), report_of(result));
}

MeshPointer decimate_mesh(const PythonMesh& mesh, std::size_t faces, double feature_angle,
                          bool keep_border, const py::object& progress) {
  Document document = mesh.document;
  const DecimateOptions options{faces, feature_angle, keep_border, document.style.coordinate};
  const DecimateResult result = without_lock(
      progress, [&](const Progress& to) { return decimate(document.mesh, options, to); });
  py::dict report;
  report["collapses"] = result.collapses;
  report["faces"] = result.faces;
  return mesh_of(std::move(document), report);
}

// --- displace, offset, shape ---------------------------------------------------------------------

void add(std::vector<Vec3>& velocities, const std::vector<Vec3>& more) {
  for (std::size_t v = 0; v < velocities.size(); ++v) velocities[v] += more[v];
}

MeshPointer displace_mesh(const PythonMesh& mesh, const std::optional<py::array>& velocities,
                          const std::optional<PythonLength>& normal_speed, double curvature_speed,
                          double time_step, double alpha) {
  Document document = mesh.document;
  const Mesh& moving = document.mesh;
  const bool has_speed = velocities || normal_speed || curvature_speed != 0;
  std::vector<Vec3> sum(moving.positions.size(), Vec3::Zero());
  if (velocities) {
    sum = vectors_of(*velocities, "velocities");
  } else if (!has_speed || has_column_velocities(moving)) {
    sum = column_velocities(moving);
  }
  if (normal_speed) add(sum, normal_velocities(moving, Lengths(document)(*normal_speed)));
  if (curvature_speed != 0) add(sum, curvature_velocities(moving, curvature_speed));
  const DisplaceResult result = without_lock(py::none(), [&](const Progress&) {
    return displace(document.mesh, sum, {time_step, alpha});
  });
  py::dict report;
  report["moved"] = result.moved;
  report["clamped"] = result.clamped;
  report["max_displacement"] = result.max_displacement;
  report["rms_displacement"] = result.rms_displacement;
  report["mean_edge"] = result.mean_edge;
  return mesh_of(std::move(document), report);
}

MeshPointer offset_mesh(const PythonMesh& mesh, const PythonLength& distance,
                        const std::optional<PythonLength>& edge, std::size_t iterations,
                        const py::object& progress) {
  Document document = mesh.document;
  Lengths lengths(document);
  const OffsetOptions options{lengths(distance), lengths(edge, 0), iterations};
  const OffsetResult result =
      without_lock(progress, [&](const Progress& to) { return offset(document, options, to); });
  py::dict report;
  report["converged"] = result.is_done;
  report["iterations"] = result.iterations;
  report["components"] = result.topology.components;
  report["genus"] = result.topology.genus;
  report["deviation_rms"] = result.deviation.rms;
  report["deviation_max"] = result.deviation.most;
  report["missed_max"] = result.deviation.missed;
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
      arg("method") = "grow", arg("separate") = PythonLength(0.0), arg("refuse") = false,
      arg("progress") = none,
      "Removes self-intersections: the boundary of winding number at least `level`, exactly, "
      "closed, manifold, without a crossing in the numbers as written. 2 intersects two "
      "bodies. `outermost` drops cavities and what floats in them. See tm-clean(1).");
  module.def("stitch", &stitch_mesh, arg("mesh"), py::kw_only(),
             arg("tolerance") = PythonLength(0.0), arg("orient") = false, arg("one_side") = false,
             arg("flip") = false,
             "Joins a soup of triangles into a manifold mesh; turns and reverses faces. See "
             "tm-stitch(1).");
  module.def("cat", &cat, "Concatenates meshes.");
  module.def("remesh", &remesh_mesh, arg("mesh"), py::kw_only(), arg("min_edge") = none,
             arg("max_edge") = none, arg("adaptive") = none, arg("size_field") = "",
             arg("iterations") = 1, arg("smooth") = "tangential", arg("flip") = "valence",
             arg("only") = "all", arg("feature_angle") = 180.0, arg("keep_border") = false,
             arg("project") = false, arg("progress") = none,
             "Keeps edges between two lengths ('0.7x' to '1.5x' of the reference edge) and "
             "triangles round, without making a crossing. `smooth` is 'tangential', 'none' or the "
             "factor of the Laplace-Beltrami operator. See tm-remesh(1).");
  module.def("decimate", &decimate_mesh, arg("mesh"), arg("faces"), py::kw_only(),
             arg("feature_angle") = 180.0, arg("keep_border") = false, arg("progress") = none,
             "Collapses edges where the surface changes least until so many faces are left, "
             "without making a crossing. See tm-remesh(1).");
  module.def("displace", &displace_mesh, arg("mesh"), arg("velocities") = none, py::kw_only(),
             arg("normal_speed") = none, arg("curvature_speed") = 0.0, arg("time_step") = 1.0,
             arg("alpha") = DisplaceOptions().alpha,
             "Moves vertices by velocities (n, 3), or by the columns vx vy vz, by no more than "
             "alpha times the mean edge at each. See tm-displace(1).");
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
