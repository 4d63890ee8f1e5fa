/// Binds remesh and decimate, with the options of tm-remesh.
#include "arguments.h"
#include "call.h"
#include "geometry/source_points.h"
#include "python_mesh.h"
#include "transformesh/align_features.h"
#include "transformesh/decimate.h"
#include "transformesh/errors.h"
#include "transformesh/remesh.h"

namespace transformesh::python {
namespace {

struct RemeshChoices {
  std::optional<PythonLength> min_edge, max_edge, adaptive, min_film, pinch;
  std::string size_field;
  std::optional<SmoothingChoice> smooth;
  std::optional<std::string> flip;
  std::string only;
  bool curved = false;
};

/// An angle in degrees, or "auto".
using FeatureAngle = std::variant<double, std::string>;

/// Returns the angle for RemeshOptions: 0 for "auto".
double angle_of(const FeatureAngle& angle) {
  if (const auto* word = std::get_if<std::string>(&angle)) {
    choice("feature_angle", *word, {"auto"});
    return 0;
  }
  const double degrees = std::get<double>(angle);
  if (!(degrees > 0)) throw UsageError("feature_angle: 'auto', or degrees above 0");
  return degrees;
}

/// Returns the options as tm-remesh does: relative lengths refer to the reference edge, or to the
/// local size.
RemeshOptions remesh_options(const RemeshChoices& choices, Document& document) {
  RemeshOptions options = choices.curved ? curved_remeshing() : RemeshOptions();
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
  if (choices.min_film) options.min_film = lengths(*choices.min_film);
  if (choices.pinch) options.pinch = lengths(*choices.pinch);
  if (choices.smooth) {
    options.smoothing = Smoothing::tangential;
    set_smoothing(*choices.smooth, options);
  }
  if (choices.flip) {
    const std::size_t flip = choice("flip", *choices.flip, {"valence", "angle", "none"});
    options.flip = flip == 0 ? FlipRule::valence : flip == 1 ? FlipRule::angle : FlipRule::none;
  }
  options.only_smooth = choice("only", choices.only, {"all", "smooth"}) == 1;
  options.coordinate = document.style.coordinate;
  return options;
}

// --- remesh --------------------------------------------------------------------------------------

/// Returns the options of alignment. Throws if options are set that only remeshing has.
AlignOptions align_options(const RemeshOptions& remesh, const RemeshChoices& choices) {
  const RemeshOptions usual;
  const char* const refused = choices.adaptive                      ? "adaptive"
                              : !choices.size_field.empty()         ? "size_field"
                              : remesh.iterations != 1              ? "iterations"
                              : remesh.curved                       ? "curved"
                              : remesh.min_film != 0                ? "min_film"
                              : remesh.pinch != 0                   ? "pinch"
                              : remesh.smoothing != usual.smoothing ? "smooth"
                              : remesh.flip != usual.flip           ? "flip"
                              : remesh.only_smooth                  ? "only"
                              : remesh.keep_border                  ? "keep_border"
                              : remesh.project                      ? "project"
                              : remesh.keep_out.surface != nullptr  ? "keep_out"
                                                                    : nullptr;
  if (refused)
    throw UsageError("align aligns and " + std::string(refused) +
                     " remeshes: use one after the other");
  AlignOptions options;
  if (remesh.feature_angle_deg > 0) options.feature_angle_deg = remesh.feature_angle_deg;
  options.min_edge = remesh.min_edge;
  options.max_edge = remesh.max_edge;
  options.coordinate = remesh.coordinate;
  return options;
}

MeshPointer remesh_mesh(
    const PythonMesh& mesh, const std::optional<PythonLength>& min_edge,
    const std::optional<PythonLength>& max_edge, const std::optional<PythonLength>& adaptive,
    const std::string& size_field, int iterations, const std::optional<SmoothingChoice>& smooth,
    const std::optional<std::string>& flip, const std::string& only,
    const FeatureAngle& feature_angle, bool keep_border, bool project, bool curved,
    const std::optional<PythonLength>& min_film, const std::optional<PythonLength>& pinch,
    const std::optional<MeshPointer>& align, const std::optional<MeshPointer>& keep_out,
    const std::optional<PythonLength>& gap, bool source, const py::object& progress) {
  Document document = mesh.document;
  Entries report = join_places(document.mesh);
  const RemeshChoices choices{min_edge,   max_edge, adaptive, min_film, pinch,
                              size_field, smooth,   flip,     only,     curved};
  RemeshOptions options = remesh_options(choices, document);
  options.iterations = iterations;
  options.feature_angle_deg = angle_of(feature_angle);
  options.keep_border = keep_border;
  options.project = project;
  Lengths lengths(document);
  options.keep_out = keep_out_of(keep_out, gap, lengths);
  if (align) {
    const AlignOptions aligning = align_options(options, choices);
    Mesh target = (*align)->document.mesh;
    join_places(target);
    const AlignResult result = without_lock(progress, [&](const Progress& to) {
      return change_with_source_points(source, document.mesh, [&](Mesh& changed) {
        return align_features(changed, target, aligning, to);
      });
    });
    append(report, entries_of(result));
    return mesh_of(std::move(document), report);
  }
  const RemeshResult result = without_lock(progress, [&](const Progress& to) {
    return change_with_source_points(source, document.mesh,
                                     [&](Mesh& changed) { return remesh(changed, options, to); });
  });
  append(report, entries_of(result));
  return mesh_of(std::move(document), report);
}

// --- decimate ------------------------------------------------------------------------------------

MeshPointer decimate_mesh(const PythonMesh& mesh, std::optional<std::size_t> faces,
                          const std::optional<PythonLength>& error, double feature_angle,
                          bool keep_border, const std::optional<MeshPointer>& keep_out,
                          const std::optional<PythonLength>& gap, bool source,
                          const py::object& progress) {
  if (!faces && !error) throw UsageError("give faces, error or both");
  if (faces == 0) throw UsageError("a closed surface has at least 4 faces; 0 are too few");
  Document document = mesh.document;
  Entries report = join_places(document.mesh);
  Lengths lengths(document);
  DecimateOptions options{faces.value_or(0), feature_angle, keep_border, document.style.coordinate,
                          keep_out_of(keep_out, gap, lengths)};
  if (error) options.error = lengths(*error);
  const DecimateResult result = without_lock(progress, [&](const Progress& to) {
    return change_with_source_points(source, document.mesh,
                                     [&](Mesh& changed) { return decimate(changed, options, to); });
  });
  append(report, entries_of(result));
  return mesh_of(std::move(document), report);
}

}  // namespace

void bind_remeshing(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  module.def(
      "remesh", &remesh_mesh, arg("mesh"), py::kw_only(), arg("min_edge") = none,
      arg("max_edge") = none, arg("adaptive") = none, arg("size_field") = "", arg("iterations") = 1,
      arg("smooth") = none, arg("flip") = none, arg("only") = "all", arg("feature_angle") = "auto",
      arg("keep_border") = false, arg("project") = false, arg("curved") = false,
      arg("min_film") = none, arg("pinch") = none, arg("align") = none, arg("keep_out") = none,
      arg("gap") = none, arg("source") = false, arg("progress") = none,
      "Keeps edges between two lengths ('0.7x' to '1.5x' of the reference edge) and "
      "triangles round, without making a self-intersection. `smooth` is 'tangential', 'none', the "
      "factor of the Laplace-Beltrami operator, or two where it is used twice. With `curved` new "
      "vertices lie on curves and others stay, unless `smooth` is given. `min_film` keeps thicker "
      "films, `pinch` cuts necks and handles around which no longer loop goes. With "
      "`align` it moves vertices and turns edges onto the sharp edges of that mesh, which "
      "lies near, and does nothing else. Nothing comes nearer than `gap` to the mesh "
      "`keep_out`. `source` writes where on the input each vertex comes from, for carry(). "
      "See tm-remesh(1).");
  module.def(
      "decimate", &decimate_mesh, arg("mesh"), arg("faces") = none, py::kw_only(),
      arg("error") = none, arg("feature_angle") = 180.0, arg("keep_border") = false,
      arg("keep_out") = none, arg("gap") = none, arg("source") = false, arg("progress") = none,
      "Collapses edges where the surface changes least until so many faces are left, "
      "without making a self-intersection. With `error` input and result stay that close to each "
      "other in both directions; without `faces` it goes on while they do. `keep_out`, `gap` and "
      "`source` are as of remesh(). See "
      "tm-remesh(1).");
}

}  // namespace transformesh::python
