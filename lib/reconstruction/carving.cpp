#include "reconstruction/carving.h"

#include <algorithm>
#include <stdexcept>

#include "mesh/local_measures.h"
#include "reconstruction/recede.h"
#include "reconstruction/surface_doubt.h"
#include "transformesh/errors.h"
#include "views/photo/thin_plate.h"

namespace transformesh {
namespace {

/// Carving ends if photographs contradict less than this fraction of the observed area. On true
/// surfaces they contradict 0 to 0.3 %, near contours.
constexpr double least_share = 0.005;
/// Number of rounds of carving before a full sweep of steps. Rounds blur the surface, so that only
/// the surface after a full sweep can be compared. On two linked tori, the score after three rounds
/// was lower although most of a false surface between the tori was removed.
constexpr int rounds_before_settling = 4;
/// Largest number of full sweeps. It limits the time if carving does not reach the accepted
/// fraction. Other values were not measured.
constexpr int most_settlings = 4;
/// Least ratio of the new score to the best one. At lower values, carving continues because of
/// noise in the score until thin strands tear. This noise reached 0.1 % on the torus knot 2,3.
constexpr double least_improvement = 1.001;
/// Tolerated decrease of the mean overlap of outlines and exact masks. A strand that tears lowers
/// the overlap by more. Other values were not measured.
constexpr double most_outline_lost = 0.001;

/// Largest accepted ratio of the number of faces after cleaning to that before the four rounds. A
/// surface that crumples intersects itself everywhere, and cleaning cuts it to ever more faces. On
/// the torus knot 3,4 the ratio was 1.03 to 1.21 in five rounds, then 1.5 and 15. Other values were
/// not measured.
constexpr std::size_t most_growth = 2;

/// Measures by which surfaces of different rounds are compared.
struct CarvedSurface {
  double confirmed = 0;           ///< sum of the weights of windows on which photographs agree
  double contradicted_share = 0;  ///< fraction of the observed area that photographs contradict
  double outline = 1;

  double score() const { return confirmed * (1 - contradicted_share / 2); }
};

CarvedSurface measured_surface(const Mesh& mesh, const CarvingEvidence& evidence) {
  const std::vector<WindowSums> around =
      spread(evidence.of_vertex, UniformLaplacian(mesh), doubt_rings);
  const std::vector<double> areas = vertex_areas(mesh);
  double observed = 0;
  double wrong = 0;
  CarvedSurface surface;
  surface.outline = evidence.outline;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (!(around[v].weight > 0)) continue;
    const bool is_wrong = around[v].excess() > contradicted;
    observed += areas[v];
    wrong += is_wrong ? areas[v] : 0;
    surface.confirmed += is_wrong ? 0 : evidence.of_vertex[v].weight;
  }
  surface.contradicted_share = observed > 0 ? wrong / observed : 0;
  return surface;
}

// Runs four rounds of carving, then a full sweep of steps. Returns false if the surface crumples,
// or if a stage fails, for example because nothing of the surface is left.
bool carve_and_settle(Document& document, CarvingEvidence& evidence, const CarvingStages& stages) {
  const std::size_t most_faces = most_growth * document.mesh.faces.size();
  try {
    for (int round = 0; round < rounds_before_settling; ++round) {
      move_contradicted_inwards(document.mesh, evidence.of_vertex, stages.distance);
      stages.clean(document);
      if (document.mesh.faces.size() > most_faces) return false;
      stages.sweep(document);
      if (round + 1 == rounds_before_settling) stages.settle(document);
      evidence = stages.measure(document.mesh);
    }
    return true;
  } catch (const CancelledError&) {
    throw;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace

void carve(Document& document, const CarvingStages& stages) {
  CarvingEvidence evidence = stages.measure(document.mesh);
  CarvedSurface best = measured_surface(document.mesh, evidence);
  const double least_outline = best.outline - most_outline_lost;
  for (int i = 0; i < most_settlings && best.contradicted_share > least_share; ++i) {
    Document carved = document;
    if (!carve_and_settle(carved, evidence, stages)) break;
    const CarvedSurface now = measured_surface(carved.mesh, evidence);
    if (now.score() <= least_improvement * best.score() || now.outline <= least_outline) break;
    best = now;
    document = std::move(carved);
    stages.keep();
  }
}

}  // namespace transformesh
