#include "options/reconstruct_options.h"

#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"
#include "views/hull/keep_in_box.h"

namespace transformesh::tool {
namespace {

constexpr long no_limit = 999999999;

void declare_places(Program& program, ReconstructChoices& choices) {
  program.options
      .text("cameras", &choices.sources.cameras, "WHERE", "file, folder or pattern of the cameras")
      .is_needed = true;
  program.options
      .text("images", &choices.sources.images, "WHERE",
            "file, folder or pattern of the photographs")
      .is_needed = true;
  program.options.text("silhouettes", &choices.sources.silhouettes, "WHERE",
                       "masks; pixels that are not black show the object");
  program.options.named(
      "silhouettes-show", &choices.options.initial.meaning,
      {{"exact", SilhouetteMeaning::exact}, {"least", SilhouetteMeaning::least}},
      "masks show the whole object, or only a part of it: then they only pull outwards");
  program.options.text("threshold", &choices.threshold, "auto|LEVEL",
                       "without masks: intensity from 1 to 254 above which photographs show the "
                       "object (default auto; with --start, none)");
}

void declare_initial_mesh(Program& program, ReconstructChoices& choices) {
  program.options.box(
      "box", &choices.box, "X0,Y0,Z0,X1,Y1,Z1",
      "lower and upper corner of a box that contains the object; pixels that do not show "
      "the box become background");
  program.options.text("keep", &choices.keep, "auto|largest|all|SHARE",
                       "components of the hull to keep; SHARE: those of at least this share of the "
                       "largest one's volume; auto: those needed to fill the silhouettes");
  program.options.text("start", &choices.options.initial.name, "FILE",
                       "begin with this mesh instead of the visual hull");
  program.options.named(
      "clip", &choices.options.initial.clips_by_hull, {{"hull", true}, {"nothing", false}},
      "with --start: keep the part of the mesh inside the hull of exact silhouettes, or all of it");
  program.options.named("hollows", &choices.options.initial.opens_hollows,
                        {{"auto", true}, {"closed", false}},
                        "what to do with hollows that the hull fills; auto: open those that depth "
                        "maps show; closed: leave all filled at the beginning");
  program.options.text("sequence", &choices.sequence, "WHERE",
                       "time steps: a file with a name per line, a folder of folders, or a "
                       "pattern; {} in other options stands for the name");
  program.options.number("track", &choices.track, 1, 1e6,
                         "as --coarsest, for time steps that begin with the previous surface");
}

void declare_scales(Program& program, ReconstructChoices& choices) {
  program.options.flag(
      "preview", &choices.is_preview,
      "make a quick, coarse reconstruction from photographs that are reduced by a factor of 4");
  program.options.text("coarsest", &choices.coarsest, "auto|NUMBER",
                       "factor by which photographs are reduced at first; auto: up to 11.3, less "
                       "if thin parts would be lost");
  program.options.number("edge", &choices.options.scales.edge, 1, 1e6,
                         "length of edges, in pixels of the scale");
  program.options.text("last-edge", &choices.last_edge, "NUMBER",
                       "length of edges at the end, in pixels at full scale (default: as --edge)");
  program.options.integer("passes", &choices.options.sweeps, 1, no_limit,
                          "maximum number of sweeps at each scale");
  program.options.text(
      "iterations", &choices.iterations, "auto|N",
      "number of steps between two cleanings; auto: 5, or 8 if hollows are open at the beginning");
}

void declare_colors(Program& program, ReconstructChoices& choices) {
  program.options.flag("color", &choices.is_colored,
                       "color the vertices of the result, as tm-color does");
  declare_texture(program, choices.color);
}

void declare_steps(Program& program, ReconstructChoices& choices) {
  program.options.integer("pairs", &choices.options.pairs.neighbors, 1, 1000,
                          "maximum number of neighbors with which each view is compared");
  program.options.number("max-angle", &choices.options.pairs.maximum_angle_deg, 5, 180,
                         "largest angle between compared views, in degrees");
  program.options.text("window", &choices.window, "N|N,N",
                       "radius of the compared windows, 1 to 5 pixels; two numbers: at scale 2 and "
                       "above, and at smaller scales");
  program.options.number("robust", &choices.options.robust, 0, 1e300,
                         "in the last sweeps, windows that disagree NUMBER times as much as the "
                         "mean have a quarter of their weight; 0: all have the same weight");
  program.options.number("stiffness", &choices.options.step.stiffness, 0, 1e300,
                         "resistance of the surface to bending");
  program.options.number(
      "crumbs", &choices.options.crumbs, 0, 1,
      "at the end, drop components of less than this share of the largest one's volume");
  program.options.number(
      "handles", &choices.options.handles, 0, 1e300,
      "remove handles that have a loop of at most this many edges around them; 0: keep all");
  program.options.text("pull", &choices.pull, "auto|NUMBER",
                       "weight of the silhouettes; auto: 0.5, or 1.5 if views are far apart");
}

double number_of(const std::string& option, const std::string& text, double minimum) {
  const auto value = number_in<double>(text);
  if (value && *value >= minimum) return *value;
  throw UsageError("--" + option + ": '" + text + "' is not a number of at least " +
                   shortest_text(minimum));
}

std::optional<double> number_or_auto(const std::string& option, const std::string& text,
                                     double minimum) {
  if (text == "auto") return std::nullopt;
  return number_of(option, text, minimum);
}

std::optional<int> iterations_of(const std::string& text) {
  if (text == "auto") return std::nullopt;
  const auto count = number_in<int>(text);
  if (count && *count >= 1) return count;
  throw UsageError("--iterations: '" + text + "' is neither auto nor a whole number of at least 1");
}

WindowRadii windows_of(const std::string& text) {
  const auto radius_of = [&](const std::string& part) {
    const auto radius = number_in<int>(part);
    if (radius && *radius >= 1 && *radius <= 5) return *radius;
    throw UsageError("--window: '" + text + "' is not one or two numbers from 1 to 5");
  };
  const std::size_t comma = text.find(',');
  const int coarse = radius_of(text.substr(0, comma));
  return {coarse, comma == std::string::npos ? coarse : radius_of(text.substr(comma + 1))};
}

// Throws UsageError for inputs from stdin, because a continued run reads its inputs again.
void refuse_standard_input(const ReconstructChoices& choices) {
  const auto refuse = [](const std::string& option, const std::string& place) {
    if (place == "-")
      throw UsageError("--" + option +
                       ": name a file, because standard input can be read only once");
  };
  refuse("cameras", choices.sources.cameras);
  refuse("images", choices.sources.images);
  refuse("silhouettes", choices.sources.silhouettes);
  refuse("start", choices.options.initial.name);
  refuse("sequence", choices.sequence);
}

void check_sequence(const ReconstructChoices& choices, const Run& run) {
  if (choices.is_colored || choices.color.has_texture)
    throw UsageError("a --sequence cannot be colored: run tm-color on each of its surfaces");
  if (run.out().name() == "-")
    throw UsageError("--sequence needs -o FOLDER or --run FOLDER: where to write the surfaces");
  const auto check_place = [](const char* option, const std::string& place) {
    if (place.find("{}") == std::string::npos)
      throw UsageError("--" + std::string(option) + " '" + place +
                       "' holds no {}, which stands for a time step");
  };
  check_place("images", choices.sources.images);
  if (!choices.sources.silhouettes.empty()) check_place("silhouettes", choices.sources.silhouettes);
  if (!choices.loop.record.frames.empty() && choices.loop.run.empty())
    throw UsageError("--frames is not for a --sequence, whose results are its frames");
}

void check_color(const ReconstructChoices& choices, const Run& run) {
  if (choices.is_colored && choices.color.has_texture)
    throw UsageError("either --color or --texture");
  if (choices.sequence.empty()) check_texture(choices.color, run);
}

}  // namespace

void declare_reconstruction(Program& program, ReconstructChoices& choices) {
  declare_places(program, choices);
  declare_initial_mesh(program, choices);
  declare_view_check(program, choices.check, choices.sources);
  declare_scales(program, choices);
  declare_steps(program, choices);
  declare_colors(program, choices);
  declare_record(program, choices.loop, "number of sweeps between frames (default 1)", "sweep");
  program.epilog = "WHERE is a file, a folder or a quoted pattern, see tm-cameras.";
}

ReconstructionOptions reconstruction_of(const ReconstructChoices& choices, Run& run) {
  refuse_standard_input(choices);
  check_color(choices, run);
  ReconstructionOptions options = choices.options;
  InitialMeshOptions& initial = options.initial;
  initial.is_given = !initial.name.empty();
  if (!choices.threshold.empty())
    initial.threshold = ThresholdOptions{.intensity = threshold_intensity(choices.threshold)};
  if (choices.keep != "auto") initial.keep = hull_share(choices.keep);
  initial.least_agreement = choices.check.least_agreement;
  options.scales.coarsest = number_or_auto("coarsest", choices.coarsest, 1);
  options.scales.last_edge = choices.last_edge.empty()
                                 ? options.scales.edge
                                 : number_of("last-edge", choices.last_edge, 1);
  options.iterations = iterations_of(choices.iterations);
  options.windows = windows_of(choices.window);
  options.pull = number_or_auto("pull", choices.pull, 0);
  options.on_note = [&run](const std::string& text) { run.note(text); };
  options.on_detail = [&run](const std::string& text) { run.say().detail(text); };
  return options;
}

SequenceOptions sequence_of(const ReconstructChoices& choices,
                            const ReconstructionOptions& reconstruction, Run& run) {
  check_sequence(choices, run);
  SequenceOptions options;
  options.reconstruction = reconstruction;
  options.track = choices.track;
  const std::string name = '.' + run.program().name;
  if (choices.loop.run.empty()) {
    options.folder = run.out().name();
    options.states = run.out().name() + '/' + name;
  } else {
    options.states = choices.loop.run + run_file::result + name;
  }
  options.format = run.document().style.format;
  options.on_step = [&run](const std::string& text) { run.say().progress_line(text); };
  options.on_note = [&run](const std::string& text) { run.note(text); };
  return options;
}

ViewSources sources_of(const ViewSources& sources, const TimeStep& step) {
  ViewSources places = sources;
  for (std::string* place : {&places.cameras, &places.images, &places.silhouettes})
    *place = place_of(*place, step);
  return places;
}

std::vector<View> checked_views(const ViewSources& sources, const ReconstructChoices& choices,
                                Run& run) {
  ViewSources telling = sources;
  telling.on_note = [&run](const std::string& text) { run.note(text); };
  if (choices.is_preview) telling.reduction = preview_reduction;
  std::vector<View> views = views_from(telling);
  if (choices.box) keep_in_box(views, *choices.box);
  if (choices.options.initial.meaning == SilhouetteMeaning::exact)
    check_views(views, choices.check, run);
  return views;
}

void color_result(const ReconstructChoices& choices, const std::set<std::string>& views, Run& run) {
  if (!choices.is_colored && !choices.color.has_texture) return;
  std::vector<PictureView> pictures = picture_views_from(choices.sources);
  std::erase_if(pictures, [&](const PictureView& view) { return !views.contains(view.name); });
  color(run.document(), pictures, choices.color, run);
}

}  // namespace transformesh::tool
