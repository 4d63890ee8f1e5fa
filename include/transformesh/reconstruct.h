/// Reconstructs a closed surface without self-intersection from calibrated photographs (paper 5.3).
/// The visual hull, or a given mesh, evolves towards agreement of the photographs, from coarse to
/// fine. A sweep is remesh(), steps towards the photographs (photo_step.h), and clean(). The
/// topology follows the photographs: the loop separates parts that the hull joins.
///
/// If the first scale fails or loses thin parts, and was not set by the caller, the loop restarts
/// at the next finer scale. If the surface explodes (falls apart or leaves the silhouettes), the
/// loop restarts with four times the stiffness, at most twice. The vertex column `doubt` is the
/// disagreement of photographs beyond their noise, in [0, 1]. It is 1 at vertices that fewer than
/// two views observe. Deterministic for any number of threads.
///
/// The initial mesh is returned if the surface still explodes, or if it was given and the result
/// does not agree clearly better with photographs and exact masks: see ReconstructionResult::kept.
#pragma once

#include <string>
#include <vector>

#include "transformesh/iteration.h"
#include "transformesh/loop.h"
#include "transformesh/reconstruction_options.h"

namespace transformesh {

/// A connected set of vertices with a doubt above 0.5.
struct DoubtfulPlace {
  Vec3 center = Vec3::Zero();
  double area = 0;          ///< area of the place in squared pixels, >= 25
  bool is_thin = false;     ///< most of the place has an opposite sheet within six pixels
  bool has_handle = false;  ///< the place contains a loop that does not separate the surface
};

struct ReconstructionResult {
  std::size_t sweeps = 0;  ///< number of sweeps (iterations), including earlier runs
  std::string fault;       ///< reason why the result is not converged; empty if it is converged
  std::string kept;        ///< reason why the initial mesh is the result, else empty
  double restored = 0;     ///< fraction of vertices moved back onto a given initial mesh; [0, 1]
  Topology topology;
  std::size_t crumbs = 0;   ///< small components that were dropped at the end
  std::size_t handles = 0;  ///< handles that were removed
  double pixel = 0;         ///< length of a pixel's side at the object; input units
  std::size_t faces = 0;
  PhotoStepResult first, last;  ///< measures of the initial surface and of the result
  double first_agreement = 1;   ///< mean intersection over union of initial and exact silhouettes
  double agreement = 1;         ///< mean intersection over union of resulting and exact silhouettes
  double disagreement = 0;      ///< mean disagreement of photographs beyond noise; [0, 1]
  double noise_floor = 0;       ///< mean dissimilarity that noise explains
  double doubtful = 0;          ///< fraction of the observed area in doubtful places
  std::vector<DoubtfulPlace> doubtful_places;  ///< doubtful places, the largest first
};

/// Reconstructs into `document`, which contains the initial mesh if one is given. Views without
/// silhouettes get some by threshold. Throws as the stages do, with the number of the sweep. The
/// document is then that of the last successful sweep.
ReconstructionResult reconstruct(Document& document, Views& views,
                                 const ReconstructionOptions& options = {},
                                 const RecordOptions& record = {},
                                 const Progress& progress = Progress());

}  // namespace transformesh
