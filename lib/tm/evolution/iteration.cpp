#include "tm/evolution/iteration.h"

#include <utility>

#include "tm/clean/clean.h"
#include "tm/evolution/stopwatch.h"
#include "tm/io/mesh_io.h"
#include "tm/mesh/components.h"
#include "tm/mesh/measure.h"
#include "tm/support/counted.h"

namespace transformesh {
namespace {

Topology topology_of(const Components& found) { return {found.components.size(), found.genus()}; }

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

IterationOptions completed(IterationOptions options, const Mesh& mesh) {
  if (options.reference_edge == 0) options.reference_edge = measured_reference_edge(mesh);
  return options;
}

std::string in_words(std::size_t faces, const Topology& topology) {
  return counted(faces, "face") + ", " + counted(topology.components, "part") + ", genus " +
         std::to_string(topology.genus);
}

std::string in_short(std::size_t faces, const Topology& topology) {
  return counted(faces, "face") + ", components " + std::to_string(topology.components) +
         ", genus " + std::to_string(topology.genus);
}

double IterationResult::moved_share() const {
  return static_cast<double>(displaced.moved) / static_cast<double>(vertices);
}

void IterationResult::measure_mesh(CsvRow& row) const {
  row.count("faces", faces).count("pairs", pairs);
  row.count("components", topology.components).count("genus", topology.genus);
}

void IterationResult::measure_times(CsvRow& row) const {
  row.number("mean_edge", displaced.mean_edge).seconds("seconds_step", seconds_step);
  row.seconds("seconds_clean", seconds_clean).seconds("seconds_remesh", seconds_remesh);
  row.seconds("seconds", seconds);
}

CleanedTopology clean_in_place(Document& document, const Progress& progress, bool outermost) {
  CleanResult result = clean(
      document.mesh, {.outermost = outermost, .coordinate = document.style.coordinate}, progress);
  document.mesh = std::move(result.mesh);
  round_as_written(document);
  CleanedTopology cleaned{{}, result.changed, result.pairs, {}};
  if (result.connectivity) {
    cleaned.topology = topology_of(result.connectivity->components);
    cleaned.opposites = std::move(result.connectivity->opposites);
  } else {
    cleaned.topology = topology_of(connected_components(document.mesh));
  }
  return cleaned;
}

RemeshResult remesh_in_place(Document& document, const IterationOptions& options,
                             const Progress& progress, std::vector<Index> opposites) {
  RemeshResult result =
      remesh(document.mesh, remesh_options(document, options), progress, std::move(opposites));
  round_as_written(document);
  return result;
}

IterationResult iterate(Document& document, const Step& step, const IterationOptions& options,
                        const Progress& progress) {
  IterationResult result;
  result.vertices = document.mesh.positions.size();
  Stopwatch watch;
  result.displaced = step(document.mesh, progress);
  round_as_written(document);
  result.seconds_step = watch.lap();

  CleanedTopology cleaned = clean_in_place(document, progress, options.outermost);
  result.pairs = cleaned.pairs;
  result.seconds_clean = watch.lap();

  const RemeshResult remeshed =
      remesh_in_place(document, options, progress, std::move(cleaned.opposites));
  result.topology = {cleaned.topology.components - remeshed.components_removed,
                     cleaned.topology.genus};
  result.faces = document.mesh.faces.size();
  result.seconds_remesh = watch.lap();
  result.seconds = result.seconds_step + result.seconds_clean + result.seconds_remesh;
  return result;
}

}  // namespace transformesh
