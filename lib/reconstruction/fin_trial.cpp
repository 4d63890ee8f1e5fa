#include "reconstruction/fin_trial.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reconstruction/surface_doubt.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/fill.h"
#include "views/photo/thin_plate.h"

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
  std::vector<bool> is_near(mesh.positions.size());
  for (const std::vector<Index>& fin : fins)
    for (const Index v : fin) is_near[v] = true;
  const UniformLaplacian laplacian(mesh);
  for (int ring = 0; ring < doubt_rings + 1; ++ring) {
    const std::vector<bool> before = is_near;
    for (Index v = 0; v < before.size(); ++v)
      if (before[v])
        for (const Index neighbor : laplacian.neighbors(v)) is_near[neighbor] = true;
  }
  std::vector<bool> keeps;
  for (const Face& face : mesh.faces)
    keeps.push_back(std::none_of(face.begin(), face.end(), [&](Index v) { return is_near[v]; }));
  return select_faces(mesh, keeps);
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
