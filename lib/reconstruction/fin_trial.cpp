#include "reconstruction/fin_trial.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reconstruction/surface_doubt.h"
#include "reconstruction/without_rings.h"
#include "transformesh/errors.h"
#include "transformesh/fill.h"

namespace transformesh {
namespace {

using Fins = std::vector<std::vector<Index>>;

std::size_t size_of(const Fins& fins) {
  std::size_t size = 0;
  for (const std::vector<Index>& fin : fins) size += fin.size();
  return size;
}

/// Returns the mesh without all faces near the fins. Unobserved vertices are `doubt_rings` rings
/// away from the first window, so that the base of a fin has as many rings more. A last ring goes,
/// too, so that single vertices inside of the fin do not leave detached faces.
Mesh without(const Fins& fins, const Mesh& mesh) {
  std::vector<bool> is_in_fin(mesh.positions.size());
  for (const std::vector<Index>& fin : fins)
    for (const Index v : fin) is_in_fin[v] = true;
  return without_rings(mesh, std::move(is_in_fin), doubt_rings + 1);
}

}  // namespace

bool try_without_fins(Document& document, double pixel, const FinTrialStages& stages,
                      const Progress& progress) {
  const CarvingEvidence before = stages.measure(document.mesh);
  const Fins fins = unobserved_fins(document.mesh, before.of_vertex, pixel, progress);
  if (fins.empty()) return false;
  Document tried = document;
  tried.mesh = without(fins, document.mesh);
  try {
    const FillOptions options{.coordinate = document.style.coordinate};
    const FillResult result = fill_holes(tried.mesh, options, progress);
    if (result.filled() < result.holes) return false;
    stages.clean(tried);
    const CarvingEvidence after = stages.measure(tried.mesh);
    if (after.outline < before.outline ||
        size_of(unobserved_fins(tried.mesh, after.of_vertex, pixel, progress)) >= size_of(fins))
      return false;
  } catch (const CancelledError&) {
    throw;
  } catch (const std::runtime_error&) {
    return false;
  }
  document = std::move(tried);
  return true;
}

}  // namespace transformesh
