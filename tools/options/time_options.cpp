#include "options/time_options.h"

#include <cmath>
#include <cstdlib>
#include <memory>

#include "evolution/filter_step.h"
#include "frame/filter_process.h"
#include "frame/velocity_process.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

/// Distance of bodies that rest on each other. The gap below a body as large as one reference edge
/// has a millionth of its volume. Much smaller distances would be below the spacing of coordinates
/// far from the origin, so that changes near the contact could not be tested.
constexpr Length resting{1e-6, Length::Unit::reference_edge};

Length gap_of(const std::string& contact) {
  constexpr std::string_view gap = "gap:";
  if (contact == "stop") return resting;
  if (contact.starts_with(gap)) return parse_length(contact.substr(gap.size()));
  throw UsageError("--contact: '" + contact + "' is neither gap:LENGTH nor stop");
}

/// Parses --time-step. With --time, the value is the time span of a step. Without --time, the value
/// is the factor by which velocities are multiplied.
double number_of(const std::string& text) {
  const auto number = number_in<double>(text);
  if (number && std::isfinite(*number)) return *number;
  throw UsageError("--time-step: '" + text + "' is not a number");
}

void tell_command(const Moment& moment, std::size_t iteration) {
  setenv("TM_ITERATION", std::to_string(iteration).c_str(), 1);
  setenv("TM_TIME", shortest_text(moment.time).c_str(), 1);
  setenv("TM_TIME_STEP", shortest_text(moment.span).c_str(), 1);
  setenv("TM_STAGE", std::to_string(moment.stage).c_str(), 1);
}

/// Returns a velocity field that runs the command for each evaluation.
VectorField velocity_through(const std::string& command,
                             const std::function<std::size_t()>& iteration) {
  return [command, iteration](const Mesh& mesh, const Moment& moment, const Progress&) {
    tell_command(moment, iteration());
    return velocities_in(run_filter(command, bytes_for_filter(mesh)));
  };
}

/// Returns a velocity field that starts the command once and keeps it running for all evaluations.
VectorField velocity_from(const std::string& command) {
  auto process = std::make_shared<VelocityProcess>(command);
  return [process](const Mesh& mesh, const Moment& moment, const Progress&) {
    return process->velocities(bytes_for_filter(mesh), moment);
  };
}

}  // namespace

void declare_time(Program& program, TimeChoices& choices) {
  OptionSet& options = program.options;
  options.number("time", &choices.end, 0, 1e300,
                 "evolve from time 0 to this time, by --flow or --velocity (default 0: evolve by "
                 "--step, without time)");
  options.choice("flow", &choices.flow, flow_names(), "flow of tm-flow that moves the vertices");
  declare_flow(options, choices.flow_options);
  options.text(
      "velocity", &choices.velocity, "COMMAND",
      "filter that reads the mesh of a Runge-Kutta stage and writes its velocities vx vy vz; "
      "TM_TIME, TM_TIME_STEP and TM_STAGE are the time, the span of the step and the stage");
  options.flag("persistent", &choices.persistent,
               "start the command of --velocity only once, and send it one mesh after another");
  options.text("time-step", &choices.span, "NUMBER|auto",
               "with --time: span of each step (default auto: as long as --max-move permits); with "
               "--step: factor by which vx vy vz are multiplied (default 1)");
  options.named(
      "integrator", &choices.options.integrator,
      {{"euler", Integrator::euler}, {"midpoint", Integrator::midpoint}, {"rk4", Integrator::rk4}},
      "Runge-Kutta method of order 1, 2 or 4");
  options.number("max-move", &choices.options.max_move, 1e-6, 1e6,
                 "with --time-step auto: largest movement of a vertex in a step, as a multiple of "
                 "the mean length of its edges");
  options.length("tolerance", &choices.tolerance,
                 "with --time-step auto: largest local error of a step (default: no limit)");
  options.number("event-tolerance", &choices.options.event_tolerance, -1, 1e300,
                 "span of time within which changes of components or genus are located; 0: repeat "
                 "no steps (default -1: a thousandth of --time)");
  options.flag("keep-volume", &choices.options.keep_volume,
               "restore the volume after cleaning and remeshing");
  options.text(
      "bodies", &choices.options.bodies, "COLUMN",
      "face property with the number of the body; bodies evolve one by one and do not touch");
  options.text(
      "contact", &choices.contact, "gap:LENGTH|stop",
      "with --bodies: bodies keep this distance, or stop when they meet (default gap:0.05x)");
}

std::initializer_list<const char*> time_option_names() {
  static constexpr std::initializer_list<const char*> names{
      "flow",        "speed",      "period",     "center",   "direction", "column",
      "grid",        "grid-step",

      "velocity",    "persistent", "integrator", "max-move", "tolerance", "event-tolerance",
      "keep-volume", "bodies",     "contact"};
  return names;
}

void check_time(const TimeChoices& choices) {
  if (choices.velocity.empty() == choices.flow.empty())
    throw UsageError("with --time, give either --flow NAME or --velocity COMMAND");
  if (choices.options.bodies.empty() && choices.contact != TimeChoices().contact)
    throw UsageError("--contact is for several bodies: name their face property with --bodies");
}

double time_factor(const TimeChoices& choices) {
  if (choices.span == "auto")
    throw UsageError("--time-step auto needs --time T, the end of an evolution in time");
  return choices.span.empty() ? 1 : number_of(choices.span);
}

TimeOptions time_options_of(const TimeChoices& choices, Run& run) {
  TimeOptions options = choices.options;
  options.end = choices.end;
  if (!choices.span.empty() && choices.span != "auto") {
    options.span = number_of(choices.span);
    if (!(options.span > 0)) throw UsageError("--time-step: with --time, a step needs a span > 0");
  }
  if (!options.bodies.empty()) options.gap = run.length(gap_of(choices.contact));
  if (choices.tolerance) options.tolerance = run.length(*choices.tolerance);
  return options;
}

Flow motion_of(const TimeChoices& choices, const std::function<std::size_t()>& iteration) {
  if (!choices.flow.empty()) return flow_of(choices.flow, choices.flow_options);
  if (choices.persistent) return {{velocity_from(choices.velocity)}, nullptr};
  return {{velocity_through(choices.velocity, iteration)}, nullptr};
}

void check_integrator(const Flow& flow, const TimeChoices& choices, const Program& program) {
  if (!flow.motion.displacement) return;
  for (const char* name : {"integrator", "tolerance"})
    if (program.options.find(name)->is_given)
      throw UsageError("the flow '" + choices.flow +
                       "' has implicit steps and does not support --" + name +
                       ": limit their span with --max-move or --time-step");
}

void note_time(const TimeResult& result, const TimeChoices& choices, Run& run) {
  const bool is_given = !choices.span.empty() && choices.span != "auto";
  if (is_given && result.max_move > 1) {
    run.note("vertices moved by up to " + significant(result.max_move, 2) +
             " mean edges in a step; a smaller --time-step, or auto, follows the motion better");
  }
  if (result.evolution.last.faces == 0)
    run.note("the surface vanished at time " + significant(result.time, 4));
  const double volume =
      std::max(std::abs(result.volume), std::abs(result.volume - result.volume_drift));
  if (!choices.options.keep_volume && result.evolution.last.faces > 0 &&
      std::abs(result.volume_drift) > 0.01 * volume) {
    run.note(
        "remeshing changed the volume by " + significant(result.volume_drift, 3) +
        (run.program().options.find("curved")->is_given
             ? ": remesh the source first, by tm-remesh --edge LENGTH, or use shorter edges, by "
               "--min-edge and --max-edge"
             : ": --curved keeps the volume and sharp edges"));
  }
  if (choices.options.keep_volume &&
      std::abs(result.volume_drift) > 1e-9 * std::abs(result.volume)) {
    const bool is_float = run.document().style.coordinate == Scalar::float32;
    run.note("the volume differs by " + significant(result.volume_drift, 3) +
             ", which could not be restored" +
             (is_float
                  ? ": 32-bit coordinates are rounded; run tm-convert --double first"
                  : ": it changed where the surface merged, split, vanished, lost sharp edges, or "
                    "had edges longer than --max-edge"));
  }
}

}  // namespace transformesh::tool
