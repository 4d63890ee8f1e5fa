/// One step of a surface towards photographs (paper 5.3.1): down the gradient of their
/// inconsistency, towards their silhouettes, clamped to alpha times the local mean edge.
///
/// gauss_newton: movements d along the vertex normals that lower the quadratic model of the energy,
/// damped by `damping` compared pixels a squared pixel, plus the bending of a thin plate
/// (thin_plate.h) and a quadratic pull towards silhouettes. Free of units, contrast and scale.
/// gradient: the paper's d = -t (gradient of the energy per unit of area), in length^-3: t is in
/// length^4, so that it depends on the units of the mesh. Silhouettes pull by their share of the
/// gap, and vertices move by `smoothing` of the way to the mean of their neighbors.
///
/// Positions change, nothing else does. The result may intersect itself; that is what clean() is
/// for. Cost: see photoconsistency.h. The same bytes for any number of threads.
#pragma once

#include "step/displace.h"
#include "views/photo/contour_gaps.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photoconsistency.h"

namespace transformesh {

enum class PhotoStepRule { gauss_newton, gradient };
/// Of the pairs of views that are compared: those whose first index is the lower one, or the
/// higher.
enum class PairOrder { both, rising, falling };

struct PhotoStepOptions {
  PhotoStepRule rule = PhotoStepRule::gauss_newton;
  double alpha = 0.5;      ///< clamp as a fraction of the local mean edge; >= 0, the paper has 0.1
  double stiffness = 1;    ///< of the plate, in median curvatures of the energy; >= 0
  double damping = 0.006;  ///< >= 0
  double time_step = 0.001;  ///< t of `gradient`; >= 0
  double smoothing = 0.1;    ///< of `gradient`; in [0, 1]
  double silhouettes = 1;    ///< pull of silhouettes; 1 is that of photographs; >= 0
  SilhouetteMeaning meaning = SilhouetteMeaning::exact;
  PairOrder order = PairOrder::both;
  double least_cosine = 0.1;  ///< of ray and normal: faces seen more flatly are not compared; >= 0
  PhotoconsistencyOptions photographs = {};
};

/// All but `displaced` and `mean_share` is measured before the movement.
struct PhotoStepResult {
  double energy = 0;
  double dissimilarity = 0;  ///< energy by weight: mean of 1 - cc
  std::size_t pixels = 0;    ///< compared, over all pairs
  double coverage = 0;       ///< share of these in the pixels that see the surface
  std::size_t unseen = 0;    ///< vertices that no pair sees
  std::size_t outside = 0;   ///< vertices more than a pixel outside a silhouette
  double mean_share = 0;     ///< mean movement as a fraction of the local mean edge
  DisplaceResult displaced;
};

/// Throws UsageError for options out of range, InputError where no pair of views sees anything.
PhotoStepResult photo_step(Mesh& mesh, const PhotoScene& scene,
                           const PhotoStepOptions& options = {}, const Progress& progress = {});

}  // namespace transformesh
