#include "reconstruction/surface_quality.h"

#include <algorithm>

namespace transformesh {
namespace {

std::ptrdiff_t fault_count(const std::string& faults) {
  return faults.empty() ? 0 : 1 + std::count(faults.begin(), faults.end(), '+');
}

}  // namespace

std::string tracking_faults(const SurfaceQuality& surface, const SurfaceQuality& reference) {
  std::string faults;
  const auto add = [&](bool is_fault, const char* name) {
    if (is_fault && !faults.empty()) faults += '+';
    if (is_fault) faults += name;
  };
  add(surface.dissimilarity > 1.3 * reference.dissimilarity, "dissimilarity");
  add(surface.coverage < 0.9 * reference.coverage, "coverage");
  add(surface.least_agreement < reference.least_agreement - 0.03, "silhouettes");
  return faults;
}

bool is_better(const SurfaceQuality& anew, const SurfaceQuality& tracked,
               const SurfaceQuality& reference) {
  const auto of_anew = fault_count(tracking_faults(anew, reference));
  const auto of_tracked = fault_count(tracking_faults(tracked, reference));
  return of_anew < of_tracked ||
         (of_anew == of_tracked && anew.dissimilarity < tracked.dissimilarity);
}

}  // namespace transformesh
