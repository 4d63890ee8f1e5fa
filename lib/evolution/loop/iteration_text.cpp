#include "evolution/loop/iteration_text.h"

#include "evolution/loop/csv_row.h"
#include "support/counted.h"

namespace transformesh {

std::string in_words(std::size_t faces, const Topology& topology) {
  return counted(faces, "face") + ", " + counted(topology.components, "component") + ", genus " +
         std::to_string(topology.genus);
}

std::string in_short(std::size_t faces, const Topology& topology) {
  return counted(faces, "face") + ", components " + std::to_string(topology.components) +
         ", genus " + std::to_string(topology.genus);
}

double moved_share(const IterationResult& result) {
  return static_cast<double>(result.displaced.moved) / static_cast<double>(result.vertices);
}

double clamped_share(const IterationResult& result) {
  return static_cast<double>(result.displaced.clamped) / static_cast<double>(result.vertices);
}

void measure_mesh(const IterationResult& result, CsvRow& row) {
  row.count("faces", result.faces).count("pairs", result.pairs);
  row.count("components", result.topology.components).count("genus", result.topology.genus);
}

void measure_times(const IterationResult& result, CsvRow& row) {
  row.number("mean_edge", result.displaced.mean_edge).seconds("seconds_step", result.seconds_step);
  row.seconds("seconds_clean", result.seconds_clean)
      .seconds("seconds_remesh", result.seconds_remesh);
  row.seconds("seconds", result.seconds);
}

}  // namespace transformesh
