/// Reconstructs a closed surface without self-intersection from calibrated photographs (paper 5.3):
/// the visual hull, or a given mesh, evolves towards agreement of the photographs, from coarse to
/// fine. A sweep is remesh(), steps towards the photographs (photo_step.h), and clean(). The
/// topology follows the photographs: the loop separates what the hull joins.
///
/// If the first scale fails or loses thin parts, and was not asked for, the loop starts again at
/// the next finer scale. If the surface explodes, it starts again four times as stiff, twice at
/// most. The vertex column `doubt` is the disagreement of photographs beyond their noise, from 0 to
/// 1, and 1 at vertices that fewer than two views observe. Deterministic for any number of threads.
#pragma once

#include <string>
#include <vector>

#include "transformesh/iteration.h"
#include "transformesh/loop.h"
#include "transformesh/reconstruction_options.h"

namespace transformesh {

/// Neighboring vertices with a doubt above one half.
struct DoubtfulPlace {
  Vec3 center = Vec3::Zero();
  double area = 0;       ///< squared pixels, >= 25
  bool is_thin = false;  ///< most of it has another side of the surface within six pixels
};

struct ReconstructionResult {
  std::size_t sweeps = 0;  ///< sweeps, with those of earlier runs
  std::string fault;       ///< why the result is not converged; empty if it is
  Topology topology;
  std::size_t crumbs = 0;   ///< components that were dropped at the end
  std::size_t handles = 0;  ///< handles that were removed
  double pixel = 0;         ///< length of a pixel's side at the object; input units
  std::size_t faces = 0;
  PhotoStepResult first, last;  ///< measures of the initial surface and of the result
  double first_agreement = 1;   ///< initial surface and exact silhouettes; mean over views
  double agreement = 1;         ///< result and exact silhouettes; mean over views
  double disagreement = 0;      ///< mean, between photographs beyond their noise; 0 to 1
  double noise_floor = 0;       ///< mean dissimilarity that noise explains
  double doubtful = 0;          ///< fraction of the observed area in doubtful places
  std::vector<DoubtfulPlace> doubtful_places;  ///< the largest first
};

/// Reconstructs into `document`, which holds the mesh to begin with if that is given. Views without
/// silhouettes get some by threshold. Throws what the stages throw, with the number of the sweep,
/// and GoalError if the surface explodes; the document is then that of the last good sweep.
ReconstructionResult reconstruct(Document& document, Views& views,
                                 const ReconstructionOptions& options = {},
                                 const RecordOptions& record = {},
                                 const Progress& progress = Progress());

}  // namespace transformesh
