/// The loops: evolutions with any velocity, morphs, reconstructions.
#include "call.h"
#include "python_mesh.h"
#include "tm/evolution/evolve.h"
#include "tm/evolution/morphing.h"
#include "tm/evolution/reconstruction.h"
#include "tm/io/mesh_io.h"
#include "tm/step/morph_check.h"
#include "tm/step/target_file.h"
#include "tm/support/error.h"
#include "tm/views/cameras/view_files.h"
#include "tm/views/hull/hull.h"

namespace transformesh::python {
namespace {

/// As the loops' programs have it: the end of an evolution is PLY, and knows its reference edge.
Document beginning(const PythonMesh& mesh) {
  Document document = mesh.document;
  document.style.format = Format::ply_little;
  return document;
}

IterationOptions iteration_of(const PythonLength& min_edge, const PythonLength& max_edge,
                              const std::variant<double, std::string>& smooth, Document& document) {
  IterationOptions options;
  options.min_edge = parsed(min_edge);
  options.max_edge = parsed(max_edge);
  options.reference_edge = Lengths(document).reference_edge();
  options.remesh = RemeshOptions();
  if (const auto* factor = std::get_if<double>(&smooth)) {
    options.remesh = smoothed_by(*factor);
  } else if (std::get<std::string>(smooth) == "none") {
    options.remesh.smoothing = Smoothing::none;
  } else if (std::get<std::string>(smooth) != "tangential") {
    throw UsageError("smooth: a number, 'tangential' or 'none'");
  }
  return options;
}

LoopOptions loop_of(std::size_t iterations, const py::object& on_iteration) {
  LoopOptions loop{iterations};
  if (!on_iteration.is_none())
    loop.on_iteration = [on_iteration](const std::string& message) {
      const py::gil_scoped_acquire locked;
      on_iteration(message);
    };
  return loop;
}

// --- evolve --------------------------------------------------------------------------------------

/// A Python function of the mesh as it is now, which returns (n, 3) velocities.
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
                        const std::variant<double, std::string>& smooth, bool outermost,
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
  py::dict report;
  report["converged"] = result.is_done;
  report["iterations"] = result.iterations;
  report["components"] = result.last.topology.components;
  report["genus"] = result.last.topology.genus;
  report["max_displacement"] = result.last.displaced.max_displacement;
  report["rms_displacement"] = result.last.displaced.rms_displacement;
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

py::dict report_of(const MorphingResult& result) {
  py::dict report;
  report["converged"] = result.stop == MorphingStop::converged;
  report["stop"] = name_of(result.stop);
  report["iterations"] = result.iterations;
  report["components"] = result.topology.components;
  report["genus"] = result.topology.genus;
  report["rms_distance_to_target"] = result.distances.to_target.rms;
  report["max_distance_to_target"] = result.distances.to_target.maximum;
  report["rms_distance_from_target"] = result.distances.from_target.rms;
  report["max_distance_from_target"] = result.distances.from_target.maximum;
  report["fault"] = result.agreement.fault;
  report["mean_edge"] = result.distances.displaced.mean_edge;
  return report;
}

MeshPointer morph_mesh(const PythonMesh& source, const PythonMesh& target, std::size_t iterations,
                       double alpha, double time_step, const std::string& distance,
                       const PythonLength& min_edge, const PythonLength& max_edge,
                       const std::variant<double, std::string>& smooth, double gap_edges,
                       int scales, const py::object& on_iteration, const py::object& progress) {
  Document document = beginning(source);
  MorphingOptions options;
  options.iteration = iteration_of(min_edge, max_edge, smooth, document);
  options.step.distance = distance_of(distance);
  options.step.displace = {time_step, alpha};
  options.step.gap_edges = gap_edges;
  options.scales = scales;
  const LoopOptions loop = loop_of(iterations, on_iteration);
  const MorphingResult result = without_lock(progress, [&](const Progress& to) {
    // As of a file, so that faces come in the same order.
    Target read = read_target(write_mesh(target.document).bytes, "the target");
    check_target(read, "", to);
    check_source(document.mesh, read, "");
    prepare_target(read, options, to);
    Record record;
    return morph(document, read, options, loop, record, to);
  });
  return mesh_of(std::move(document), report_of(result));
}

// --- hull, reconstruct ---------------------------------------------------------------------------

double share_of(const std::variant<double, std::string>& keep) {
  if (const auto* share = std::get_if<double>(&keep)) return *share;
  if (std::get<std::string>(keep) == "largest") return 1;
  if (std::get<std::string>(keep) == "all") return 0;
  throw UsageError("keep: largest, all or a number from 0 to 1");
}

MeshPointer make_hull(const std::string& cameras, const std::string& silhouettes, int resolution,
                      const std::optional<double>& edge,
                      const std::variant<double, std::string>& keep, const py::object& progress) {
  HullOptions options;
  options.resolution = resolution;
  options.edge = edge;
  options.keep = share_of(keep);
  HullResult result = without_lock(progress, [&](const Progress& to) {
    return visual_hull(views_from({cameras, "", silhouettes}), options, to);
  });
  py::dict report;
  report["cell"] = result.cell;
  report["dropped_components"] = result.dropped_components;
  Document document;
  document.mesh = std::move(result.mesh);
  return mesh_of(std::move(document), report);
}

py::dict report_of(const ReconstructionResult& result) {
  py::dict report;
  report["converged"] = result.fault.empty();
  report["fault"] = result.fault;
  report["passes"] = result.passes;
  report["pixel_size"] = result.pixel;
  report["components"] = result.topology.components;
  report["genus"] = result.topology.genus;
  report["dissimilarity"] = result.last.dissimilarity;
  report["coverage"] = result.last.coverage;
  return report;
}

MeshPointer reconstruct_surface(const std::string& cameras, const std::string& images,
                                const std::string& silhouettes,
                                const std::optional<MeshPointer>& start, double edge,
                                const std::optional<double>& last_edge,
                                const std::optional<double>& coarsest, std::size_t passes,
                                const std::variant<double, std::string>& keep,
                                const py::object& on_pass, const py::object& progress) {
  ReconstructionOptions options;
  options.start.keep = share_of(keep);
  options.start.is_given = start.has_value();
  options.scales.edge = edge;
  options.scales.last_edge = last_edge.value_or(edge);
  options.scales.coarsest = coarsest;
  options.passes = passes;
  options.on_pass = loop_of(0, on_pass).on_iteration;
  Document document = start ? (*start)->document : Document();
  const ReconstructionResult result = without_lock(progress, [&](const Progress& to) {
    std::vector<View> views = views_from({cameras, images, silhouettes});
    Record record;
    return reconstruct(document, views, options, record, to);
  });
  return mesh_of(std::move(document), report_of(result));
}

}  // namespace

void bind_evolutions(py::module_& module) {
  using py::arg;
  const py::object none = py::none();
  const PythonLength shortest("0.7x");
  const PythonLength longest("1.5x");
  module.def("evolve", &evolve_mesh, arg("mesh"), arg("velocity"), py::kw_only(),
             arg("iterations") = 100, arg("time_step") = 1.0,
             arg("alpha") = DisplaceOptions().alpha, arg("min_edge") = shortest,
             arg("max_edge") = longest, arg("smooth") = 0.1, arg("outermost") = true,
             arg("until") = none, arg("on_iteration") = none, arg("progress") = none,
             "An evolution: vertices move along `velocity(mesh)`, an array (n, 3), "
             "self-intersections are removed, the surface is remeshed, again and again. `until` is "
             "a length, by which no vertex moves any more, or 'stalled'. See tm-evolve(1).");
  module.def("morph", &morph_mesh, arg("source"), arg("target"), py::kw_only(),
             arg("iterations") = LoopOptions().iterations, arg("alpha") = DisplaceOptions().alpha,
             arg("time_step") = MorphStepOptions().displace.time_step, arg("distance") = "auto",
             arg("min_edge") = shortest, arg("max_edge") = longest, arg("smooth") = 0.1,
             arg("gap_edges") = MorphStepOptions().gap_edges, arg("scales") = 1,
             arg("on_iteration") = none, arg("progress") = none,
             "Evolves a surface until it lies on a target, a mesh or points. See tm-morph(1).");
  module.def("hull", &make_hull, arg("cameras"), arg("silhouettes"), py::kw_only(),
             arg("resolution") = 100, arg("edge") = none, arg("keep") = "largest",
             arg("progress") = none,
             "The visual hull of calibrated silhouettes: files, folders or patterns. See "
             "tm-hull(1).");
  module.def("reconstruct", &reconstruct_surface, arg("cameras"), arg("images"),
             arg("silhouettes") = "", py::kw_only(), arg("start") = none,
             arg("edge") = ScaleOptions().edge, arg("last_edge") = none, arg("coarsest") = none,
             arg("passes") = ReconstructionOptions().passes, arg("keep") = "largest",
             arg("on_pass") = none, arg("progress") = none,
             "Reconstructs a closed surface from calibrated photographs: files, folders or "
             "patterns. See tm-reconstruct(1).");
}

}  // namespace transformesh::python
