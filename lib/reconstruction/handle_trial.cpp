#include "reconstruction/handle_trial.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reconstruction/start_comparison.h"
#include "transformesh/errors.h"
#include "transformesh/handles.h"

namespace transformesh {
namespace {

/// Returns the sums of the windows around vertices that are at most `reach` from one of the places.
WindowSums sums_near(const Mesh& mesh, const std::vector<WindowSums>& of_vertex,
                     const std::vector<Vec3>& places, double reach) {
  WindowSums sums;
  for (std::size_t v = 0; v < of_vertex.size(); ++v) {
    const bool is_near = std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
      return (mesh.positions[v] - place).stableNorm() <= reach;
    });
    if (is_near) sums += of_vertex[v];
  }
  return sums;
}

}  // namespace

std::optional<std::size_t> try_without_handles(Document& document, double max_length,
                                               const HandleTrialStages& stages) {
  Document without = document;
  const std::size_t removed =
      remove_handles(without.mesh, {max_length, document.style.coordinate}).removed;
  if (removed == 0) return std::nullopt;
  // Each cut duplicates the vertices of its loop.
  const auto old_count = static_cast<std::ptrdiff_t>(document.mesh.positions.size());
  const std::vector<Vec3> places(without.mesh.positions.begin() + old_count,
                                 without.mesh.positions.end());
  try {
    stages.settle(without);
  } catch (const CancelledError&) {
    throw;
  } catch (const std::runtime_error&) {
    return 0;
  }
  const auto sums = [&](const Mesh& mesh) {
    return sums_near(mesh, stages.measure(mesh), places, max_length / 2);
  };
  const WindowSums before = sums(document.mesh);
  const WindowSums after = sums(without.mesh);
  if (after.weight < before.weight || !is_clearly_less(after.excess(), before.excess())) return 0;
  document = std::move(without);
  return removed;
}

}  // namespace transformesh
