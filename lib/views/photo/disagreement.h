/// Measures how much photographs disagree on each part of a surface, and how much of this
/// disagreement noise explains.
///
/// The window around each pixel of a view is compared with the other views of its pairs
/// (correlation.h, which also defines cc, rho, v1 and v2). If there are three or more comparisons
/// of a pixel, the second best one counts, else the best one. The reason is that even on the true
/// surface some views observe a point at a grazing angle or near an occluding contour. On a wrong
/// surface, no two views agree. The dissimilarity of a vertex is the mean of 1 - cc over the
/// windows around it, weighted by rho and by the vertex's barycentric weight.
///
/// The floor is the dissimilarity that is expected if photographs differ only by noise: the mean of
/// (variance of the noise + CorrelationOptions::noise_variance) / sqrt(v1 v2). In generated scenes,
/// dissimilarity and floor differ by .01 to .09 on the true surface, and by .5 or more on wrong
/// surfaces.
#pragma once

#include <span>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photoconsistency.h"

namespace transformesh {

/// Sums over compared windows, for example those around a vertex.
struct WindowSums {
  double weight = 0;  ///< sum of the weights of windows; 0 if nothing is compared
  double energy = 0;  ///< sum of weight times (1 - correlation)
  double floor = 0;   ///< sum of weight times floor, the dissimilarity that noise explains

  double dissimilarity() const { return weight > 0 ? energy / weight : 0; }
  double mean_floor() const { return weight > 0 ? floor / weight : 0; }
  /// Returns the dissimilarity beyond the floor, from 0 (explained by noise) to 1 (nothing in
  /// common).
  double excess() const;
  WindowSums& operator+=(const WindowSums& other);
};

struct Disagreement {
  WindowSums all;
  std::vector<WindowSums> of_vertex;
};

/// Compares the photographs of a scene on a surface, for all pairs of views in the scene. The noise
/// estimate assumes photographs at full resolution, as at_scale() returns them for scale 1. If they
/// were shrunk, the estimated variance is up to a tenth too large. `least_cosine` has the same
/// meaning as in PhotoStepOptions. Takes a little longer than photoconsistency(), and throws as
/// photoconsistency() does. The result does not depend on the number of threads.
Disagreement disagreement(const Mesh& mesh, const PhotoScene& scene, double least_cosine,
                          const PhotoconsistencyOptions& options = {},
                          const Progress& progress = {});

/// Returns the variance of the noise in a photograph that at_scale() returned for any scale, in
/// squared intensities. Uses pixels at which `depth` is above 0; returns 0 if there are none. The
/// variance is estimated from mixed second differences, which texture hardly affects unless it is
/// as fine as the pixels. Reference: Immerkaer, "Fast noise variance estimation", CVIU 64(2), 1996.
/// Unlike in this reference, the median of the differences is used, not their mean. O(pixels).
double noise_variance(const GrayImage& image, const GrayImage& depth);

}  // namespace transformesh
