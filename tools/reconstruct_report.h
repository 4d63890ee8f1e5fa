/// What tm-reconstruct says at the end.
#pragma once

#include <algorithm>

#include "evolution/sequence.h"
#include "frame/run.h"
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
  const SurfaceEvidence& evidence = result.evidence;
  run.report("first_silhouette_agreement", evidence.first_agreement);
  run.report("silhouette_agreement", evidence.agreement);
  run.report("noise_floor", evidence.doubt.floor);
  run.report("disagreement", evidence.doubt.disagreement);
  run.report("doubtful", evidence.doubt.share);
  run.report("doubtful_places", texts_of(evidence.doubt.places));
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
