/// Binds remesh and decimate.
#include "call.h"
#include "geometry/source_points.h"
#include "transformesh/align_features.h"
#include "transformesh/decimate.h"

namespace transformesh::python {
namespace {

/// Returns argument `feature_angle` in degrees; 0 for "auto".
double feature_angle(const Call& call) {
  const py::object angle = call["feature_angle"];
  if (py::isinstance<py::str>(angle)) {
    call.word("feature_angle", {"auto"});
    return 0;
  }
  const auto degrees = call.get<double>("feature_angle");
  if (!(degrees > 0)) throw UsageError("feature_angle: 'auto', or degrees above 0");
  return degrees;
}

/// Returns the argument `name`, a limit of edge lengths, in input units. If `has_sizes` is true,
/// edge lengths vary over the mesh. The limit is then a factor of the length wanted at each vertex.
double edge_length(Call& call, const char* name, const char* otherwise, bool has_sizes) {
  const Length asked = call.length_as_given(name, otherwise);
  if (!has_sizes) return call.resolve(asked);
  if (asked.unit == Length::Unit::reference_edge) return asked.value;
  throw UsageError("with size_field, min_edge and max_edge are factors of it such as '0.7x'");
}

RemeshOptions remesh_options(Call& call) {
  RemeshOptions options = call.get<bool>("curved") ? curved_remeshing() : RemeshOptions();
  const bool adapts = !call["adaptive"].is_none();
  options.adaptive_error = call.length("adaptive");
  call("size_field", options.size_column)("iterations", options.iterations)(
      "keep_border", options.keep_border)("project", options.project);
  const bool has_sizes = !options.size_column.empty();
  options.min_edge = edge_length(call, "min_edge", adapts ? "0.1x" : "0.7x", has_sizes);
  options.max_edge = edge_length(call, "max_edge", adapts ? "5x" : "1.5x", has_sizes);
  options.min_film = call.length("min_film");
  options.pinch = call.length("pinch");
  if (!call["smooth"].is_none()) call.set_smoothing(options);
  if (!call["flip"].is_none())
    options.flip = call.choice<FlipRule>(
        "flip",
        {{"valence", FlipRule::valence}, {"angle", FlipRule::angle}, {"none", FlipRule::none}});
  options.only_smooth = call.word("only", {"all", "smooth"}) == "smooth";
  options.coordinate = call.document.style.coordinate;
  options.feature_angle_deg = feature_angle(call);
  options.keep_out = call.keep_out();
  return options;
}

/// Calls `change(mesh, progress)`. If argument `source` is set, stores the point of the input mesh
/// from which each vertex and face comes.
template <typename Change>
MeshPointer changed(Call& call, const Change& change) {
  const auto source = call.get<bool>("source");
  const auto result = call.run([&](const Progress& to) {
    return change_with_source_points(source, call.document.mesh,
                                     [&](Mesh& mesh) { return change(mesh, to); });
  });
  return call.result(entries_of(result));
}

// --- remesh --------------------------------------------------------------------------------------

/// Returns the options of align_features(). Throws UsageError if an argument is set that only
/// remeshing uses.
AlignOptions align_options(const RemeshOptions& remesh, const Call& call) {
  const RemeshOptions usual;
  const char* const refused = !call["adaptive"].is_none()           ? "adaptive"
                              : !remesh.size_column.empty()         ? "size_field"
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

MeshPointer remesh_mesh(Call& call) {
  call.join();
  const RemeshOptions options = remesh_options(call);
  if (call["align"].is_none())
    return changed(call, [&](Mesh& mesh, const Progress& to) { return remesh(mesh, options, to); });
  const AlignOptions aligning = align_options(options, call);
  Mesh target = call.mesh("align").document.mesh;
  join_places(target);
  return changed(call, [&](Mesh& mesh, const Progress& to) {
    return align_features(mesh, target, aligning, to);
  });
}

// --- decimate ------------------------------------------------------------------------------------

MeshPointer decimate_mesh(Call& call) {
  const auto faces = call.get<std::optional<std::size_t>>("faces");
  const bool has_error = !call["error"].is_none();
  if (!faces && !has_error) throw UsageError("give faces, error or both");
  if (faces == 0) throw UsageError("a closed surface has at least 4 faces; 0 are too few");
  call.join();
  DecimateOptions options;
  options.faces = faces.value_or(0);
  call("feature_angle", options.feature_angle_deg)("keep_border", options.keep_border);
  options.coordinate = call.document.style.coordinate;
  options.keep_out = call.keep_out();
  if (has_error) options.error = call.length("error");
  return changed(call, [&](Mesh& mesh, const Progress& to) { return decimate(mesh, options, to); });
}

}  // namespace

void bind_remeshing(py::module_& module) {
  define_filter(module, "remesh", &remesh_mesh);
  define_filter(module, "decimate", &decimate_mesh);
}

}  // namespace transformesh::python
