#include "tm/evolution/iteration.h"

#include <utility>

#include "tm/clean/clean.h"
#include "tm/evolution/stopwatch.h"
#include "tm/io/mesh_io.h"
#include "tm/mesh/components.h"
#include "tm/mesh/measure.h"

namespace transformesh {
namespace {

Topology topology_of(const Mesh& mesh) {
  const Components found = connected_components(mesh);
  return {found.components.size(), found.genus()};
}

RemeshOptions remesh_options(const Document& document, const IterationOptions& options) {
  const auto resolved = [&](const Length& length) {
    const bool is_factor = !options.remesh.size_column.empty();
    const double base = is_factor ? 1 : options.reference_edge;
    const bool needs_diagonal = length.unit == Length::Unit::diagonal;
    const double diagonal = needs_diagonal ? bounding_box(document.mesh).diagonal() : 0;
    return length.resolve(diagonal, base);
  };
  RemeshOptions result = options.remesh;
  result.min_edge = resolved({options.edge_factor * options.min_edge.value, options.min_edge.unit});
  result.max_edge = resolved({options.edge_factor * options.max_edge.value, options.max_edge.unit});
  result.coordinate = document.style.coordinate;
  return result;
}

}  // namespace

Step step_along(Velocity velocity, const DisplaceOptions& options) {
  return [velocity = std::move(velocity), options](Mesh& mesh, const Progress& progress) {
    return displace(mesh, velocity(mesh, progress), options);
  };
}

RemeshOptions smoothed_by(double factor) {
  RemeshOptions options;
  options.smoothing = Smoothing::laplace;
  options.smooth_first = factor;
  return options;
}

CleanedTopology clean_in_place(Document& document, const Progress& progress) {
  CleanResult result =
      clean(document.mesh, {.outermost = true, .coordinate = document.style.coordinate}, progress);
  document.mesh = std::move(result.mesh);
  const Topology topology = topology_of(document.mesh);
  round_as_written(document);
  return {topology, result.changed, result.pairs};
}

IterationResult iterate(Document& document, const Step& step, const IterationOptions& options,
                        const Progress& progress) {
  IterationResult result;
  result.vertices = document.mesh.positions.size();
  Stopwatch watch;
  result.displaced = step(document.mesh, progress);
  round_as_written(document);
  result.seconds_step = watch.lap();

  const CleanedTopology cleaned = clean_in_place(document, progress);
  result.pairs = cleaned.pairs;
  result.seconds_clean = watch.lap();

  const RemeshResult remeshed = remesh(document.mesh, remesh_options(document, options), progress);
  round_as_written(document);
  result.topology = {cleaned.topology.components - remeshed.components_removed,
                     cleaned.topology.genus};
  result.faces = document.mesh.faces.size();
  result.seconds_remesh = watch.lap();
  return result;
}

}  // namespace transformesh
