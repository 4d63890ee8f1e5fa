#include "reconstruction/reconstruction_entries.h"

#include <algorithm>
#include <string>

#include "reconstruction/surface_doubt.h"

namespace transformesh {
namespace {

/// Largest number of doubtful places in a report; keeps reports short.
constexpr std::size_t most_places = 10;

std::string texts_of(const std::vector<DoubtfulPlace>& places) {
  std::string text;
  for (std::size_t i = 0; i < std::min(places.size(), most_places); ++i)
    text += (i > 0 ? "; " : "") + in_words(places[i]);
  return text;
}

std::string stop_of(const ReconstructionResult& result) {
  if (!result.kept.empty()) return "start kept";
  return result.fault.empty() ? "converged" : "not converged";
}

}  // namespace

Entries entries_of(const ReconstructionResult& result) {
  return {{"pixel_size", result.pixel},
          {"passes", result.sweeps},
          {"converged", result.fault.empty()},
          {"fault", result.fault},
          {"stop", stop_of(result)},
          {"kept", result.kept},
          {"restored", result.restored},
          {"crumbs", result.crumbs},
          {"handles", result.handles},
          {"components", result.topology.components},
          {"genus", result.topology.genus},
          {"first_dissimilarity", result.first.dissimilarity},
          {"dissimilarity", result.last.dissimilarity},
          {"first_coverage", result.first.coverage},
          {"coverage", result.last.coverage},
          {"first_pixels", result.first.pixels},
          {"pixels", result.last.pixels},
          {"first_silhouette_agreement", result.first_agreement},
          {"silhouette_agreement", result.agreement},
          {"noise_floor", result.noise_floor},
          {"disagreement", result.disagreement},
          {"doubtful", result.doubtful},
          {"doubtful_places", texts_of(result.doubtful_places)},
          {"mean_edge", result.last.displaced.mean_edge}};
}

Entries entries_of(const SequenceResult& result) {
  return {{"time_steps", result.time_steps},
          {"tracked", result.tracked},
          {"accepted", result.accepted}};
}

Entries entries_of(const ViewCheck& check, std::size_t views) {
  return {{"views", views},
          {"dropped_views", check.dropped.size()},
          {"least_agreement", check.least_agreement}};
}

}  // namespace transformesh
