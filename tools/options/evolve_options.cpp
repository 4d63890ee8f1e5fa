#include "options/evolve_options.h"

#include "frame/smoothing_option.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

/// Shortest edge with --adaptive, relative to the reference edge (unit x). Chosen for Enright's
/// test, in which a sphere of 5,120 faces is stretched to a thin sheet. The rims of the sheet need
/// shorter edges than the usual 0.7x. With 0.25x, the mesh has up to 53,000 faces. With 0.7x, the
/// Hausdorff distance is four times as large.
constexpr Length shortest_adaptive{0.25, Length::Unit::reference_edge};

UntilRule until_of(const std::string& text, Run& run) {
  constexpr std::string_view moved = "moved:";
  if (text.empty()) return {};
  if (text == "stalled") return stalled();
  if (text.starts_with(moved))
    return moved_less_than(run.length(parse_length(text.substr(moved.size()))));
  UntilRule rule;
  if (text.starts_with("components:")) rule.components = number_in<long>(text.substr(11));
  if (text.starts_with("genus:")) rule.genus = number_in<long>(text.substr(6));
  if (rule.components || rule.genus) return rule;
  throw UsageError("--until: '" + text +
                   "' is unknown: write moved:LENGTH, stalled, components:N or genus:N");
}

void refuse(const Program& program, std::initializer_list<const char*> names,
            const std::string& reason) {
  for (const char* name : names)
    if (program.options.find(name)->is_given) throw UsageError("--" + std::string(name) + reason);
}

void check_step(const EvolveChoices& choices, const Program& program) {
  refuse(program, {"time"}, " must be above 0");
  if (choices.step.empty()) {
    throw UsageError(
        "the motion is missing: give --step COMMAND, or --time T with --flow "
        "NAME or --velocity COMMAND");
  }
  refuse(program, time_option_names(), " needs --time T, the end of an evolution in time");
}

/// Returns the options of remeshing. With --time or --curved, smoothing is off unless --smooth is
/// given, so that it does not displace vertices that the motion has moved.
RemeshOptions remeshing_of(const EvolveChoices& choices, Run& run) {
  RemeshOptions options;
  const std::string usual = choices.is_in_time() || choices.curved ? "none" : "0.1";
  read_smoothing(choices.smooth.empty() ? usual : choices.smooth, options);
  options.curved = choices.curved;
  if (options.curved) options.flip = FlipRule::angle;
  if (choices.adaptive) options.adaptive_error = run.length(*choices.adaptive);
  if (choices.adaptive && options.adaptive_error == 0)
    throw UsageError("--adaptive: the error must be above 0");
  if (choices.min_film) options.min_film = run.length(*choices.min_film);
  if (choices.pinch) options.pinch = run.length(*choices.pinch);
  return options;
}

}  // namespace

void declare_evolve(Program& program, EvolveChoices& choices) {
  program.options.text("step", &choices.step, "COMMAND",
                       "filter that reads a mesh, and writes it with moved vertices or with "
                       "velocities vx vy vz; TM_ITERATION is the number of the iteration");
  declare_time(program, choices.time);
  declare_iterations(program, choices.loop,
                     "maximum number of iterations (default 1000; with --time no limit)");
  program.options.text("until", &choices.until, "moved:LENGTH|stalled|components:N|genus:N",
                       "stop when no vertex moves by LENGTH or more, when movements no longer "
                       "decrease, or at N components or genus N (default: none of these)");
  program.options.number("alpha", &choices.displace.alpha, 0, 1e300,
                         "with --step: largest movement of a vertex by vx vy vz, as a fraction of "
                         "the mean length of its edges");
  program.options.text(
      "smooth", &choices.smooth, "KIND",
      "smoothing, as --smooth of tm-remesh (default 0.1; with --time or --curved none)");
  program.options.length("min-edge", &choices.iteration.min_edge,
                         "collapse shorter edges (default 0.7x; with --adaptive 0.25x)");
  program.options.length("max-edge", &choices.iteration.max_edge, "split longer edges");
  program.options.flag("keep-cavities", &choices.keep_cavities,
                       "keep cavities and the components inside them (default: fill cavities)");
  program.options.flag(
      "curved", &choices.curved,
      "remesh on curves as tm-remesh --curved, which keeps smooth shapes and creases");
  program.options.length(
      "adaptive", &choices.adaptive,
      "shorten edges where the surface is curved, so that faces deviate from it by at most this");
  program.options.length("min-film", &choices.min_film,
                         "keep thin sheets, strips and rims thicker than this");
  program.options.length(
      "pinch", &choices.pinch,
      "cut and cap necks and handles that have a loop of at most this length around them");
  program.reference_edge();
  program.options
      .output_file(
          "events", &choices.loop.record.events,
          "write a line per change of topology, and write the face property component_label")
      .affects_result = false;
  declare_record(program, choices.loop, "number of iterations between frames (default 10)",
                 "iteration");
}

void check_evolve(const EvolveChoices& choices, const Program& program) {
  if (!choices.is_in_time()) return check_step(choices, program);
  refuse(program, {"step"},
         " cannot be combined with --time: give --flow NAME or --velocity COMMAND instead");
  refuse(program, {"alpha"},
         " cannot be combined with --time, because it would move vertices by different spans of "
         "time: limit the step of all vertices with --max-move");
  check_time(choices.time);
}

EvolveOptions evolution_of(const EvolveChoices& choices, Run& run) {
  EvolveOptions options{choices.iteration, until_of(choices.until, run)};
  options.iteration.reference_edge = run.in().reference_edge();
  options.iteration.outermost = !choices.keep_cavities;
  options.iteration.remesh = remeshing_of(choices, run);
  if (choices.adaptive && !run.program().options.find("min-edge")->is_given)
    options.iteration.min_edge = shortest_adaptive;
  return options;
}

}  // namespace transformesh::tool
