/// One step of a surface towards photographs (paper 5.3.1; Pons, Keriven & Faugeras, IJCV 72(2),
/// 2007) and their silhouettes. Only positions change. The result may intersect itself.
/// Deterministic for any number of threads. O(views * faces + pairs * pixels).
#pragma once

#include <limits>

#include "transformesh/displace.h"
#include "transformesh/hull.h"

namespace transformesh {

enum class Interpolation { bilinear, catmull_rom };
enum class PhotoStepRule { gauss_newton, gradient };  ///< `gradient`: the paper's; depends on units
enum class PairOrder { both, rising, falling };       ///< rising: lower view index is the reference
struct CorrelationOptions {    ///< comparison of windows by normalized cross-correlation cc
  int radius = 3;              ///< radius of windows; pixels; 1 to 5
  double noise_variance = 25;  ///< added to the variance of both windows; intensity^2; > 0
  double contrast = 25;        ///< variance at which a window has weight 1/2; 0: equal weights
  double robust = 0;  ///< value of 1 - cc that reduces a window's pull to 1/4; 0: no reduction
};
struct PhotoconsistencyOptions {
  CorrelationOptions correlation;
  Interpolation interpolation = Interpolation::catmull_rom;
  double depth_tolerance = 0.005;  ///< points deeper by more than this fraction are occluded; >= 0
};
struct PairOptions {          ///< pairs of views to compare, by the angle of their viewing rays
  std::size_t neighbors = 4;  ///< largest number of partners of each view
  double minimum_angle_deg = 4, maximum_angle_deg = 50;
  double spread = std::numeric_limits<double>::infinity();  ///< largest / best angle of pairs; >= 1
};
struct PhotoStepOptions {
  PhotoStepRule rule = PhotoStepRule::gauss_newton;
  double alpha = 0.5;      ///< largest movement / local mean edge; >= 0; 0.1 in the paper
  double stiffness = 1;    ///< thin-plate weight / median second derivative of the energy; >= 0
  double damping = 0.006;  ///< regularization: second derivative added per compared pixel; >= 0
  /// Only for `gradient`: time step in length^4, >= 0; smoothing factor in [0, 1].
  double time_step = 0.001, smoothing = 0.1;
  double silhouettes = 1;  ///< weight of silhouettes against photographs; >= 0
  SilhouetteMeaning meaning = SilhouetteMeaning::exact;
  PairOrder order = PairOrder::both;
  double least_cosine = 0.1;  ///< least cosine between ray and normal of compared faces; >= 0
  PhotoconsistencyOptions photographs = {};
};
struct PhotoStepResult {
  double energy = 0, dissimilarity = 0;  ///< sum, mean of 1 - correlation before the step
  std::size_t pixels = 0;                ///< compared pixels, summed over all pairs
  double coverage = 0;                   ///< `pixels` / pixels that show the surface; [0, 1]
  std::size_t unseen = 0, outside = 0;   ///< vertices visible in no pair; outside a silhouette
  double mean_share = 0;                 ///< mean movement as a fraction of the local mean edge
  DisplaceResult displaced;
};

/// Moves vertices. Photographs are first reduced by the factor `scale`, >= 1. Throws UsageError for
/// options out of range, and InputError if no pair of views observes the surface.
PhotoStepResult photo_step(Mesh& mesh, const Views& views, double scale,
                           const PhotoStepOptions& = {}, const PairOptions& = {},
                           const Progress& = {});

}  // namespace transformesh
