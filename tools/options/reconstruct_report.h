/// What tm-reconstruct says at the end.
#pragma once

#include <algorithm>

#include "evolution/loop/iteration_text.h"
#include "frame/run.h"
#include "reconstruction/recorded_reconstruction.h"
#include "reconstruction/sequence.h"
#include "reconstruction/surface_doubt.h"
#include "support/counted.h"

namespace transformesh::tool {

/// The largest ones, joined by semicolons.
inline std::string texts_of(const std::vector<DoubtfulPlace>& places) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
    text += (i > 0 ? "; " : "") + in_words(places[i]);
  return text;
}

inline void report_reconstruction(const ReconstructionResult& result, std::size_t views, Run& run) {
  run.report("views", views);
  run.report("pixel_size", result.pixel);
  run.report("passes", result.sweeps);
  run.report("converged", result.fault.empty());
  run.report("fault", result.fault);
  run.report("crumbs", result.crumbs);
  run.report("handles", result.handles);
  run.report("components", result.topology.components);
  run.report("genus", result.topology.genus);
  run.report("first_dissimilarity", result.first.dissimilarity);
  run.report("dissimilarity", result.last.dissimilarity);
  run.report("first_coverage", result.first.coverage);
  run.report("coverage", result.last.coverage);
  run.report("first_pixels", result.first.pixels);
  run.report("pixels", result.last.pixels);
  run.report("first_silhouette_agreement", result.first_agreement);
  run.report("silhouette_agreement", result.agreement);
  run.report("noise_floor", result.noise_floor);
  run.report("disagreement", result.disagreement);
  run.report("doubtful", result.doubtful);
  run.report("doubtful_places", texts_of(result.doubtful_places));
  run.report("mean_edge", result.last.displaced.mean_edge);
}

inline void report_sequence(const SequenceResult& result, Run& run) {
  run.report("time_steps", result.time_steps);
  run.report("tracked", result.tracked);
  run.report("accepted", result.accepted);
}

inline std::string summary_of(const SequenceResult& result) {
  return counted(result.time_steps, "time step") + ", " + std::to_string(result.tracked) +
         " tracked, " + std::to_string(result.accepted) + " as good as from the hull";
}

}  // namespace transformesh::tool
