/// How much photographs disagree on each part of a surface, and how much of that their noise
/// explains.
///
/// Each pixel of a view is compared with the other views of its pairs in windows (correlation.h).
/// Of three or more comparisons the second best counts, else the best: some views see the place
/// flatly, or beside what hides it, but of a wrong surface none agree. The dissimilarity of a
/// vertex is the mean of 1 - cc over the windows around it, weighted by rho and by its barycentric
/// weight. The floor is what it would be if photographs showed there the same but for noise: the
/// mean of (noise + noise_variance) / sqrt(v1 v2). On the true surface of generated scenes both
/// differ by .01 to .09, where it is wrong by .5 and more.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "support/progress.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photoconsistency.h"

namespace transformesh {

/// Sums over windows.
struct WindowSums {
  double weight = 0;  ///< rho; 0 where nothing is compared
  double energy = 0;  ///< rho (1 - cc)
  double floor = 0;   ///< rho times the floor

  double dissimilarity() const { return weight > 0 ? energy / weight : 0; }
  double mean_floor() const { return weight > 0 ? floor / weight : 0; }
  /// From 0, where noise explains all, to 1, where photographs have nothing in common.
  double excess() const;
  WindowSums& operator+=(const WindowSums& other);
};

struct Disagreement {
  WindowSums all;
  std::vector<WindowSums> of_vertex;
};

/// Of a scene at scale 1, whose blur is known. `least_cosine` is that of PhotoStepOptions. Throws
/// as photoconsistency() does; a little slower. The same for any number of threads.
Disagreement disagreement(const Mesh& mesh, const PhotoScene& scene, double least_cosine,
                          const PhotoconsistencyOptions& options = {},
                          const Progress& progress = {});

/// The variance of the noise in a photograph of scale 1 (at_scale), in squared intensities, where
/// `depth` is above 0; 0 where that is nowhere. It is measured as what the mixed second difference
/// leaves: texture hardly shows in it unless it is as fine as the pixels. Reference: Immerkaer,
/// "Fast noise variance estimation", CVIU 64(2), 1996; here by the median. O(pixels).
double noise_variance(const GrayImage& image, const GrayImage& depth);

}  // namespace transformesh
