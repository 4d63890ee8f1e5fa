/// Binds evolve, evolve_in_time and morph.
#include <limits>
#include <variant>

#include "advice.h"
#include "call.h"
#include "evolution/recorded_loops.h"
#include "step/morph_check.h"
#include "step/target_file.h"
#include "transformesh/evolve.h"
#include "transformesh/evolve_in_time.h"
#include "transformesh/mesh_io.h"
#include "transformesh/morph.h"

namespace transformesh::python {
namespace {

/// Prepares the mesh of the call for an evolution, and returns the options of one iteration. As in
/// the command-line programs, sets the file format to PLY, and stores the reference edge (the
/// initial mean edge length) in a comment of the mesh.
IterationOptions iteration_of(Call& call) {
  call.document.style.format = Format::ply_little;
  IterationOptions options;
  options.min_edge = call.length_as_given("min_edge", "0.7x");
  options.max_edge = call.length_as_given("max_edge", "1.5x");
  options.reference_edge = call.reference_edge();
  options.remesh = RemeshOptions();
  call.set_smoothing(options.remesh);
  return options;
}

LoopOptions loop_of(const Call& call, std::size_t iterations) {
  LoopOptions loop{iterations};
  loop.on_iteration = call.callback("on_iteration");
  return loop;
}

// --- evolve --------------------------------------------------------------------------------------

/// Calls a Python function with a mesh and further arguments, and returns the velocities that it
/// returns as an array (n, 3).
template <typename... Values>
std::vector<Vec3> velocities_by(const py::function& function, const Mesh& now, Values... values) {
  const py::gil_scoped_acquire locked;
  return vectors_of(py::array::ensure(function(mesh_of(now), values...)), "the velocities");
}

UntilRule until_of(const Call& call) {
  const auto until = call.get<std::variant<std::monostate, double, std::string>>("until");
  if (const auto* length = std::get_if<double>(&until)) return moved_less_than(*length);
  if (const auto* word = std::get_if<std::string>(&until)) {
    if (*word == "stalled") return stalled();
    throw UsageError("until: a length, 'stalled' or None");
  }
  return {};
}

MeshPointer evolve_mesh(Call& call) {
  EvolveOptions options{iteration_of(call), until_of(call)};
  call("outermost", options.iteration.outermost);
  DisplaceOptions displace;
  call("time_step", displace.time_step)("alpha", displace.alpha);
  const auto velocity = call.get<py::function>("velocity");
  const Step step = step_along(
      [&](const Mesh& now, const Progress&) { return velocities_by(velocity, now); }, displace);
  const LoopOptions loop = loop_of(call, call.get<std::size_t>("iterations"));
  const EvolveResult result =
      call.run([&](const Progress& to) { return evolve(call.document, step, options, loop, to); });
  if (result.clamped_iterations > 0)
    warn({clamps_in_words(result, displace.alpha) +
          "; use a smaller time_step and more iterations, or a larger alpha"});
  call.report = {{"converged", result.is_done}};
  return call.result(entries_of(result));
}

// --- evolve_in_time ------------------------------------------------------------------------------

py::dict volumes_of(const std::vector<LabeledVolume>& components) {
  py::dict volumes;
  for (const LabeledVolume& component : components)
    volumes[py::int_(component.label)] = component.volume;
  return volumes;
}

/// Returns a dict for each event, with the members of Event. Volumes of components before and after
/// the event are dicts from label to volume.
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

TimeOptions time_options(Call& call) {
  TimeOptions options{call.get<double>("time"),
                      call.get<std::optional<double>>("time_step").value_or(0)};
  options.integrator = call.choice<Integrator>(
      "integrator",
      {{"euler", Integrator::euler}, {"midpoint", Integrator::midpoint}, {"rk4", Integrator::rk4}});
  call("max_move", options.max_move)("keep_volume", options.keep_volume);
  options.tolerance = call.length("tolerance");
  options.event_tolerance = call.get<std::optional<double>>("event_tolerance").value_or(-1);
  return options;
}

MeshPointer evolve_mesh_in_time(Call& call) {
  EvolveOptions options{iteration_of(call), {}};
  call("outermost", options.iteration.outermost)("curved", options.iteration.remesh.curved);
  if (options.iteration.remesh.curved) options.iteration.remesh.flip = FlipRule::angle;
  call("events", options.finds_events);
  const TimeOptions in_time = time_options(call);
  const auto velocity = call.get<py::function>("velocity");
  const Motion motion{[&](const Mesh& now, const Moment& moment, const Progress&) {
    return velocities_by(velocity, now, moment.time);
  }};
  const LoopOptions loop = loop_of(call, std::numeric_limits<std::size_t>::max());
  const TimeResult result = call.run([&](const Progress& to) {
    return evolve_in_time(call.document, motion, in_time, options, loop, to);
  });
  const MeshPointer mesh = call.result(entries_of(result));
  if (options.finds_events) mesh->report["events"] = list_of(result.evolution.events);
  return mesh;
}

// --- morph ---------------------------------------------------------------------------------------

MorphOptions morph_options(Call& call) {
  MorphOptions options;
  options.iteration = iteration_of(call);
  using Distance = std::optional<MorphDistance>;
  options.step.distance = call.choice<Distance>("distance", {{"auto", {}},
                                                             {"surface", MorphDistance::surface},
                                                             {"points", MorphDistance::points},
                                                             {"vertex", MorphDistance::vertex}});
  call("time_step", options.step.displace.time_step)("alpha", options.step.displace.alpha);
  call("gap_edges", options.step.gap_edges)("scales", options.scales);
  options.features = call.choice<Features>(
      "features", {{"auto", Features::automatic}, {"on", Features::on}, {"off", Features::off}});
  return options;
}

MeshPointer morph_mesh(Call& call) {
  call.document = call.mesh("source").document;
  const MorphOptions options = morph_options(call);
  const LoopOptions loop = loop_of(call, call.get<std::size_t>("iterations"));
  const PythonMesh& target = call.mesh("target");
  std::vector<Problem> warnings;
  const Target read = call.run([&](const Progress& to) {
    // Write the target to memory and read it again. Its faces then have the same order as in the
    // command-line programs, which read it from a file.
    Target reading = read_target(write_mesh(target.document).bytes, "the target");
    warnings = check_target(reading, "the target", to);
    for (Problem& warning : check_source(call.document.mesh, reading, "the source"))
      warnings.push_back(std::move(warning));
    return reading;
  });
  warn(with_advice(warnings));
  const MorphResult result =
      call.run([&](const Progress& to) { return morph(call.document, read, options, loop, to); });
  call.report = entries_of(result);
  return call.result({{"remedy", advice_for(result.cause.kind)}});
}

}  // namespace

void bind_evolutions(py::module_& module) {
  define_filter(module, "evolve", &evolve_mesh);
  define_filter(module, "evolve_in_time", &evolve_mesh_in_time);
  define(module, "morph", &morph_mesh);
}

}  // namespace transformesh::python
