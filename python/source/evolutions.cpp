/// Binds evolve, evolve_in_time and morph.
#include <limits>

#include "advice.h"
#include "arguments.h"
#include "call.h"
#include "evolution/loop/record.h"
#include "evolution/recorded_loops.h"
#include "python_mesh.h"
#include "step/morph_check.h"
#include "step/target_file.h"
#include "transformesh/errors.h"
#include "transformesh/evolve.h"
#include "transformesh/mesh_io.h"
#include "transformesh/morph.h"

namespace transformesh::python {
namespace {

/// Returns the document at the beginning of a loop. As in the programs, its format is PLY, and it
/// has the comment with the reference edge.
Document beginning(const PythonMesh& mesh) {
  Document document = mesh.document;
  document.style.format = Format::ply_little;
  return document;
}

IterationOptions iteration_of(const PythonLength& min_edge, const PythonLength& max_edge,
                              const SmoothingChoice& smooth, Document& document) {
  IterationOptions options;
  options.min_edge = parsed(min_edge);
  options.max_edge = parsed(max_edge);
  options.reference_edge = Lengths(document).reference_edge();
  options.remesh = RemeshOptions();
  set_smoothing(smooth, options.remesh);
  return options;
}

LoopOptions loop_of(std::size_t iterations, const py::object& on_iteration) {
  LoopOptions loop{iterations};
  loop.on_iteration = message_callback(on_iteration);
  return loop;
}

// --- evolve --------------------------------------------------------------------------------------

/// Converts a Python function that receives the current mesh and returns (n, 3) velocities.
Velocity velocity_of(const py::function& function) {
  return [function](const Mesh& now, const Progress&) {
    const py::gil_scoped_acquire locked;
    Document document;
    document.mesh = now;
    return vectors_of(py::array::ensure(function(mesh_of(std::move(document)))), "the velocities");
  };
}

UntilRule until_of(const std::variant<std::monostate, double, std::string>& until) {
  if (const auto* length = std::get_if<double>(&until)) return moved_less_than(*length);
  if (const auto* word = std::get_if<std::string>(&until)) {
    if (*word == "stalled") return stalled();
    throw UsageError("until: a length, 'stalled' or None");
  }
  return {};
}

MeshPointer evolve_mesh(const PythonMesh& mesh, const py::function& velocity,
                        std::size_t iterations, double time_step, double alpha,
                        const PythonLength& min_edge, const PythonLength& max_edge,
                        const SmoothingChoice& smooth, bool outermost,
                        const std::variant<std::monostate, double, std::string>& until,
                        const py::object& on_iteration, const py::object& progress) {
  Document document = beginning(mesh);
  EvolveOptions options{iteration_of(min_edge, max_edge, smooth, document), until_of(until)};
  options.iteration.outermost = outermost;
  const Step step = step_along(velocity_of(velocity), {time_step, alpha});
  const LoopOptions loop = loop_of(iterations, on_iteration);
  const EvolveResult result = without_lock(progress, [&](const Progress& to) {
    Record record;
    return evolve(document, step, options, loop, record, to);
  });
  if (result.clamped_iterations > 0)
    warn({clamps_in_words(result, alpha) +
          "; use a smaller time_step and more iterations, or a larger alpha"});
  Entries report{{"converged", result.is_done}};
  append(report, entries_of(result));
  return mesh_of(std::move(document), report);
}

// --- evolve_in_time ------------------------------------------------------------------------------

/// Converts a Python function that receives mesh and time of a stage and returns (n, 3) velocities.
Motion motion_of(const py::function& function) {
  return {[function](const Mesh& now, const Moment& moment, const Progress&) {
    const py::gil_scoped_acquire locked;
    Document document;
    document.mesh = now;
    return vectors_of(py::array::ensure(function(mesh_of(std::move(document)), moment.time)),
                      "the velocities");
  }};
}

py::dict volumes_of(const std::vector<LabeledVolume>& components) {
  py::dict volumes;
  for (const LabeledVolume& component : components)
    volumes[py::int_(component.label)] = component.volume;
  return volumes;
}

/// Returns a dict per event: its members, with the volumes of components by their labels.
py::list list_of(const std::vector<Event>& events) {
  py::list all;
  for (const Event& event : events) {
    py::dict row;
    row["iteration"] = event.iteration;
    row["time"] = event.time;
    row["kind"] = name_of(event.kind);
    row["place"] = py::make_tuple(event.place.x(), event.place.y(), event.place.z());
    row["size"] = event.size;
    row["before"] = volumes_of(event.before);
    row["after"] = volumes_of(event.after);
    all.append(row);
  }
  return all;
}

MeshPointer evolve_mesh_in_time(const PythonMesh& mesh, const py::function& velocity, double time,
                                const std::optional<double>& time_step,
                                const std::string& integrator, double max_move,
                                const std::optional<PythonLength>& tolerance,
                                const std::optional<double>& event_tolerance, bool keep_volume,
                                const PythonLength& min_edge, const PythonLength& max_edge,
                                const SmoothingChoice& smooth, bool curved, bool outermost,
                                bool events, const py::object& on_iteration,
                                const py::object& progress) {
  Document document = beginning(mesh);
  TimeOptions time_options{time, time_step.value_or(0)};
  time_options.integrator =
      std::array{Integrator::euler, Integrator::midpoint,
                 Integrator::rk4}[choice("integrator", integrator, {"euler", "midpoint", "rk4"})];
  time_options.max_move = max_move;
  time_options.tolerance = Lengths(document)(tolerance, 0);
  time_options.event_tolerance = event_tolerance.value_or(-1);
  time_options.keep_volume = keep_volume;
  EvolveOptions options{iteration_of(min_edge, max_edge, smooth, document), {}};
  options.iteration.outermost = outermost;
  options.iteration.remesh.curved = curved;
  if (curved) options.iteration.remesh.flip = FlipRule::angle;
  options.finds_events = events;
  const Motion motion = motion_of(velocity);
  const LoopOptions loop = loop_of(std::numeric_limits<std::size_t>::max(), on_iteration);
  const TimeResult result = without_lock(progress, [&](const Progress& to) {
    Record record;
    return evolve_in_time(document, motion, time_options, options, loop, record, to);
  });
  py::dict report = dict_of(entries_of(result));
  if (events) report["events"] = list_of(result.evolution.events);
  return mesh_of(std::move(document), report);
}

// --- morph ---------------------------------------------------------------------------------------

std::optional<MorphDistance> distance_of(const std::string& name) {
  if (name == "auto") return std::nullopt;
  if (name == "surface") return MorphDistance::surface;
  if (name == "points") return MorphDistance::points;
  if (name == "vertex") return MorphDistance::vertex;
  throw UsageError("distance: '" + name + "' is none of auto, surface, points, vertex");
}

MeshPointer morph_mesh(const PythonMesh& source, const PythonMesh& target, std::size_t iterations,
                       double alpha, double time_step, const std::string& distance,
                       const PythonLength& min_edge, const PythonLength& max_edge,
                       const SmoothingChoice& smooth, double gap_edges, const std::string& features,
                       int scales, const py::object& on_iteration, const py::object& progress) {
  Document document = beginning(source);
  MorphOptions options;
  options.iteration = iteration_of(min_edge, max_edge, smooth, document);
  options.step.distance = distance_of(distance);
  options.step.displace = {time_step, alpha};
  options.step.gap_edges = gap_edges;
  options.features = std::array{Features::automatic, Features::on,
                                Features::off}[choice("features", features, {"auto", "on", "off"})];
  options.scales = scales;
  const LoopOptions loop = loop_of(iterations, on_iteration);
  std::vector<Problem> warnings;
  const Target read = without_lock(progress, [&](const Progress& to) {
    // Writes and reads the target, so that its faces have the same order as in the programs.
    Target reading = read_target(write_mesh(target.document).bytes, "the target");
    warnings = check_target(reading, "the target", to);
    for (Problem& warning : check_source(document.mesh, reading, "the source"))
      warnings.push_back(std::move(warning));
    return reading;
  });
  warn(with_advice(warnings));
  const MorphResult result = without_lock(progress, [&](const Progress& to) {
    Record record;
    return morph(document, read, options, loop, record, to);
  });
  Entries report = entries_of(result);
  report.emplace_back("remedy", std::string(advice_for(result.cause.kind)));
  return mesh_of(std::move(document), report);
}

}  // namespace

void bind_evolutions(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  const PythonLength shortest("0.7x");
  const PythonLength longest("1.5x");
  module.def(
      "evolve", &evolve_mesh, arg("mesh"), arg("velocity"), py::kw_only(), arg("iterations") = 100,
      arg("time_step") = 1.0, arg("alpha") = DisplaceOptions().alpha, arg("min_edge") = shortest,
      arg("max_edge") = longest, arg("smooth") = 0.1, arg("outermost") = true, arg("until") = none,
      arg("on_iteration") = none, arg("progress") = none,
      "An evolution: vertices move along `velocity(mesh)`, an array (n, 3), "
      "self-intersections are removed, the surface is remeshed, again and again. `until` is "
      "a length, by which no vertex moves any more, or 'stalled'. A vertex moves by "
      "`time_step` times its velocity, but by no more than `alpha` times the mean edge at "
      "it: a warning, and `clamped_iterations` and `clamped_share` of the report, state where "
      "that is less. `smooth` 0.1 shrinks what is curved; 'none' and 'tangential' keep the "
      "volume. See tm-evolve(1).");
  module.def(
      "evolve_in_time", &evolve_mesh_in_time, arg("mesh"), arg("velocity"), arg("time"),
      py::kw_only(), arg("time_step") = none, arg("integrator") = "midpoint",
      arg("max_move") = TimeOptions().max_move, arg("tolerance") = none,
      arg("event_tolerance") = none, arg("keep_volume") = false, arg("min_edge") = shortest,
      arg("max_edge") = longest, arg("smooth") = "none", arg("curved") = false,
      arg("outermost") = true, arg("events") = false, arg("on_iteration") = none,
      arg("progress") = none,
      "Evolves a surface from time 0 to `time` along `velocity(mesh, time)`, an array (n, 3). In a "
      "step all vertices move by the same span of time: `time_step`, or as long as no vertex moves "
      "farther than `max_move` of its own edges and, if `tolerance` is given, the local error is "
      "at "
      "most that length. `curved` remeshes on curves, which keeps smooth shapes. With `events`, "
      "`report['events']` is a list of the changes of topology: dicts of iteration, time, kind, "
      "place, size, and the volumes of the components before and after by their labels. Faces have "
      "these in the column component_label. See TIME and EVENTS in tm-evolve(1).");
  module.def("morph", &morph_mesh, arg("source"), arg("target"), py::kw_only(),
             arg("iterations") = LoopOptions().iterations, arg("alpha") = DisplaceOptions().alpha,
             arg("time_step") = MorphStepOptions().displace.time_step, arg("distance") = "auto",
             arg("min_edge") = shortest, arg("max_edge") = longest, arg("smooth") = 0.1,
             arg("gap_edges") = MorphStepOptions().gap_edges, arg("features") = "auto",
             arg("scales") = 1, arg("on_iteration") = none, arg("progress") = none,
             "Evolves a surface until it lies on a target, a mesh or points. `features`, 'auto', "
             "'on' or 'off', says whether vertices and edges are aligned with the target's sharp "
             "edges at the end. See tm-morph(1).");
}

}  // namespace transformesh::python
