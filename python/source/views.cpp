/// Binds hull and reconstruct, which check the calibrated photographs first.
#include <algorithm>
#include <utility>
#include <variant>

#include "call.h"
#include "evolution/loop/record.h"
#include "reconstruction/reconstruction_entries.h"
#include "reconstruction/recorded_reconstruction.h"
#include "reconstruction/surface_doubt.h"
#include "transformesh/hull.h"
#include "transformesh/reconstruct.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"
#include "views/hull/hull_values.h"
#include "views/hull/keep_in_box.h"
#include "views/hull/view_check.h"

namespace transformesh::python {
namespace {

/// Returns argument `keep` as a number: "largest" is 1, "all" is 0. Returns nothing for "auto".
std::optional<double> share_of(const Call& call) {
  const auto keep = call.get<std::variant<double, std::string>>("keep");
  if (const auto* share = std::get_if<double>(&keep)) return *share;
  const std::string& word = std::get<std::string>(keep);
  if (word == "largest") return 1;
  if (word == "all") return 0;
  return std::nullopt;
}

struct CheckedViews {
  std::vector<View> views;
  ViewCheck check;
};

/// Reads the views. If `options` are given, checks whether the silhouettes of the views agree.
/// Notes that programs print on stderr become Python warnings.
CheckedViews checked_views(const Call& call, ViewSources sources,
                           const std::optional<ViewCheckOptions>& options,
                           const std::optional<Box>& box = {}) {
  std::vector<std::string> notes;
  sources.on_note = [&notes](const std::string& note) { notes.push_back(note); };
  CheckedViews read = call.run([&](const Progress& to) {
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

ViewCheckOptions check_options(const Call& call) {
  ViewCheckOptions options;
  call("least_agreement", options.least_agreement)("drop_bad_views", options.drops_bad_views);
  return options;
}

MeshPointer make_hull(Call& call) {
  HullOptions options;
  call("resolution", options.resolution)("edge", options.edge);
  const std::optional<double> keep = share_of(call);
  if (!keep) throw UsageError("keep: largest, all or a number from 0 to 1");
  options.keep = *keep;
  options.box = call.box();
  const CheckedViews checked = checked_views(
      call, {call.path("cameras"), "", call.path("silhouettes"), call.get<bool>("mirror")},
      check_options(call));
  HullResult result =
      call.run([&](const Progress& to) { return visual_hull(checked.views, options, to); });
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

WindowRadii radii_of(const Call& call) {
  const auto window = call.get<std::variant<int, std::pair<int, int>>>("window");
  const auto* one = std::get_if<int>(&window);
  const auto [coarse, fine] =
      one != nullptr ? std::pair(*one, *one) : std::get<std::pair<int, int>>(window);
  if (std::min(coarse, fine) < 1 || std::max(coarse, fine) > 5)
    throw UsageError("window: one or two numbers from 1 to 5");
  return {coarse, fine};
}

InitialMeshOptions initial_options(const Call& call) {
  InitialMeshOptions initial;
  initial.name = "start";
  initial.is_given = !call["start"].is_none();
  initial.keep = share_of(call);
  if (!initial.keep) call.word("keep", {"auto", "largest", "all"});
  initial.clips_by_hull = call.word("clip", {"hull", "nothing"}) == "hull";
  initial.opens_hollows = call.word("hollows", {"auto", "closed"}) == "auto";
  initial.meaning = call.choice<SilhouetteMeaning>(
      "silhouettes_show",
      {{"exact", SilhouetteMeaning::exact}, {"least", SilhouetteMeaning::least}});
  call("least_agreement", initial.least_agreement);
  return initial;
}

ReconstructionOptions reconstruction_options(const Call& call) {
  ReconstructionOptions options;
  options.initial = initial_options(call);
  options.windows = radii_of(call);
  call("max_angle", options.pairs.maximum_angle_deg)("edge", options.scales.edge);
  options.scales.last_edge =
      call.get<std::optional<double>>("last_edge").value_or(options.scales.edge);
  call("coarsest", options.scales.coarsest)("passes", options.sweeps)("robust", options.robust);
  call("iterations", options.iterations)("crumbs", options.crumbs)("handles", options.handles);
  options.on_sweep = call.callback("on_pass");
  return options;
}

MeshPointer reconstruct_surface(Call& call) {
  ReconstructionOptions options = reconstruction_options(call);
  std::vector<std::string> notes;
  options.on_note = [&notes](const std::string& note) { notes.push_back(note); };
  std::optional<ViewCheckOptions> check;
  if (options.initial.meaning == SilhouetteMeaning::exact) check = check_options(call);
  ViewSources sources{call.path("cameras"), call.path("images"), call.path("silhouettes"),
                      call.get<bool>("mirror")};
  if (call.get<bool>("preview")) sources.reduction = preview_reduction;
  CheckedViews checked = checked_views(call, sources, check, call.box());
  if (options.initial.is_given) call.document = call.mesh("start").document;
  const ReconstructionResult result = call.run([&](const Progress& to) {
    Record record;
    return reconstruct(call.document, checked.views, options, record, to);
  });
  warn(notes);
  call.report = entries_of(checked.check, checked.views.size());
  const MeshPointer mesh = call.result(entries_of(result));
  mesh->report["doubtful_places"] = places_of(result.doubtful_places);
  return mesh;
}

}  // namespace

void bind_views(py::module_& module) {
  define(module, "hull", &make_hull);
  define(module, "reconstruct", &reconstruct_surface);
}

}  // namespace transformesh::python
