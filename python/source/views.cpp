/// Binds hull and reconstruct, which check the calibrated photographs first.
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "arguments.h"
#include "call.h"
#include "evolution/loop/record.h"
#include "python_mesh.h"
#include "reconstruction/reconstruction_entries.h"
#include "reconstruction/recorded_reconstruction.h"
#include "reconstruction/surface_doubt.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "transformesh/reconstruct.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"
#include "views/hull/hull_values.h"
#include "views/hull/keep_in_box.h"
#include "views/hull/view_check.h"

namespace transformesh::python {
namespace {

double share_of(const std::variant<double, std::string>& keep) {
  if (const auto* share = std::get_if<double>(&keep)) return *share;
  if (std::get<std::string>(keep) == "largest") return 1;
  if (std::get<std::string>(keep) == "all") return 0;
  throw UsageError("keep: largest, all or a number from 0 to 1");
}

struct CheckedViews {
  std::vector<View> views;
  ViewCheck check;
};

/// Reads the views and, if `options` are given, checks whether they agree. Notes that programs
/// print on stderr become Python warnings.
CheckedViews checked_views(ViewSources sources, const std::optional<ViewCheckOptions>& options,
                           const py::object& progress, const std::optional<Box>& box = {}) {
  std::vector<std::string> notes;
  sources.on_note = [&notes](const std::string& note) { notes.push_back(note); };
  CheckedViews read = without_lock(progress, [&](const Progress& to) {
    to("read views");
    CheckedViews reading{views_from(sources), {}};
    if (box) keep_in_box(reading.views, *box);
    if (options) reading.check = check_views(reading.views, *options, to);
    return reading;
  });
  for (const BadView& view : read.check.dropped) notes.push_back(in_words(view));
  warn(notes);
  return read;
}

// --- hull ----------------------------------------------------------------------------------------

using Path = std::filesystem::path;

MeshPointer make_hull(const Path& cameras, const Path& silhouettes, int resolution,
                      const std::optional<double>& edge,
                      const std::variant<double, std::string>& keep, const py::object& box,
                      double least_agreement, bool drop_bad_views, bool mirror,
                      const py::object& progress) {
  HullOptions options;
  options.resolution = resolution;
  options.edge = edge;
  options.keep = share_of(keep);
  options.box = optional_box(box);
  const CheckedViews checked =
      checked_views({cameras.string(), "", silhouettes.string(), mirror},
                    ViewCheckOptions{least_agreement, drop_bad_views}, progress);
  HullResult result = without_lock(
      progress, [&](const Progress& to) { return visual_hull(checked.views, options, to); });
  Entries report = entries_of(checked.check, checked.views.size());
  append(report, {{"cell", result.cell}, {"dropped_components", result.dropped_components}});
  return mesh_of(std::move(result.mesh), report);
}

// --- reconstruct ---------------------------------------------------------------------------------

py::list places_of(const std::vector<DoubtfulPlace>& doubtful) {
  py::list places;
  for (const DoubtfulPlace& place : doubtful) places.append(in_words(place));
  return places;
}

using Window = std::variant<int, std::pair<int, int>>;

WindowRadii radii_of(const Window& window) {
  const auto* one = std::get_if<int>(&window);
  const auto [coarse, fine] =
      one != nullptr ? std::pair(*one, *one) : std::get<std::pair<int, int>>(window);
  if (std::min(coarse, fine) < 1 || std::max(coarse, fine) > 5)
    throw UsageError("window: one or two numbers from 1 to 5");
  return {coarse, fine};
}

/// Returns nothing for "auto".
std::optional<double> share_or_auto(const std::variant<double, std::string>& keep) {
  const auto* word = std::get_if<std::string>(&keep);
  if (word != nullptr && *word == "auto") return std::nullopt;
  return share_of(keep);
}

InitialMeshOptions initial_options_of(const std::optional<double>& keep, const std::string& clip,
                                      const std::string& hollows, bool is_exact,
                                      double least_agreement) {
  InitialMeshOptions initial;
  initial.name = "start";
  initial.keep = keep;
  initial.clips_by_hull = choice("clip", clip, {"hull", "nothing"}) == 0;
  initial.opens_hollows = choice("hollows", hollows, {"auto", "closed"}) == 0;
  if (!is_exact) initial.meaning = SilhouetteMeaning::least;
  initial.least_agreement = least_agreement;
  return initial;
}

MeshPointer reconstruct_surface(
    const Path& cameras, const Path& images, const Path& silhouettes,
    const std::optional<MeshPointer>& start, const std::string& clip,
    const std::string& silhouettes_show, double edge, const std::optional<double>& last_edge,
    const std::optional<double>& coarsest, std::size_t sweeps, const std::optional<int>& iterations,
    double robust, const std::variant<double, std::string>& keep, const std::string& hollows,
    const Window& window, double max_angle, double crumbs, double handles, const py::object& box,
    double least_agreement, bool drop_bad_views, bool mirror, bool preview,
    const py::object& on_pass, const py::object& progress) {
  ReconstructionOptions options;
  const bool is_exact = choice("silhouettes_show", silhouettes_show, {"exact", "least"}) == 0;
  options.initial =
      initial_options_of(share_or_auto(keep), clip, hollows, is_exact, least_agreement);
  options.initial.is_given = start.has_value();
  options.windows = radii_of(window);
  options.pairs.maximum_angle_deg = max_angle;
  options.scales = {coarsest, edge, last_edge.value_or(edge)};
  options.sweeps = sweeps;
  options.iterations = iterations;
  options.robust = robust;
  options.crumbs = crumbs;
  options.handles = handles;
  options.on_sweep = message_callback(on_pass);
  std::vector<std::string> notes;
  options.on_note = [&notes](const std::string& note) { notes.push_back(note); };
  std::optional<ViewCheckOptions> check;
  if (is_exact) check = {least_agreement, drop_bad_views};
  ViewSources sources{cameras.string(), images.string(), silhouettes.string(), mirror};
  if (preview) sources.reduction = preview_reduction;
  CheckedViews checked = checked_views(sources, check, progress, optional_box(box));
  Document document = start ? (*start)->document : Document();
  const ReconstructionResult result = without_lock(progress, [&](const Progress& to) {
    Record record;
    return reconstruct(document, checked.views, options, record, to);
  });
  warn(notes);
  Entries entries = entries_of(checked.check, checked.views.size());
  append(entries, entries_of(result));
  py::dict report = dict_of(entries);
  report["doubtful_places"] = places_of(result.doubtful_places);
  return mesh_of(std::move(document), report);
}

}  // namespace

void bind_views(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  module.def("hull", &make_hull, arg("cameras"), arg("silhouettes"), py::kw_only(),
             arg("resolution") = HullOptions().resolution, arg("edge") = none,
             arg("keep") = "largest", arg("box") = none,
             arg("least_agreement") = ViewCheckOptions().least_agreement,
             arg("drop_bad_views") = false, arg("mirror") = false, arg("progress") = none,
             "The visual hull of calibrated silhouettes: files, folders or patterns. Views that "
             "disagree with the rest are refused, or with `drop_bad_views` left out, which is a "
             "warning; `least_agreement` 0 believes them. `mirror` is for cameras of a left-handed "
             "world. See tm-hull(1).");
  module.def(
      "reconstruct", &reconstruct_surface, arg("cameras"), arg("images"), arg("silhouettes") = "",
      py::kw_only(), arg("start") = none, arg("clip") = "hull", arg("silhouettes_show") = "exact",
      arg("edge") = ScaleOptions().edge, arg("last_edge") = none, arg("coarsest") = none,
      arg("passes") = ReconstructionOptions().sweeps, arg("iterations") = none,
      arg("robust") = ReconstructionOptions().robust, arg("keep") = "auto", arg("hollows") = "auto",
      arg("window") = 3, arg("max_angle") = PairOptions().maximum_angle_deg,
      arg("crumbs") = ReconstructionOptions().crumbs,
      arg("handles") = ReconstructionOptions().handles, arg("box") = none,
      arg("least_agreement") = ViewCheckOptions().least_agreement, arg("drop_bad_views") = false,
      arg("mirror") = false, arg("preview") = false, arg("on_pass") = none, arg("progress") = none,
      "Reconstructs a surface from calibrated photographs: files, folders or "
      "patterns. Views are checked as of hull(). What went wrong on the way, as a surface "
      "that exploded and was begun anew, is a warning; the report has the keys of the "
      "program's. See tm-reconstruct(1).");
}

}  // namespace transformesh::python
