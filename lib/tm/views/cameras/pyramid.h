/// Photographs with fewer pixels, for evolutions from coarse to fine (paper 5.3.1).
///
/// Every pixel of the smaller image is the mean over its area in the larger one, after a Gaussian
/// of deviation 0.45 scale, in pixels of the larger image, that keeps finer detail out; of 0.6 at
/// scale 1, where it only tames noise. Beyond the border the outermost pixels continue. The camera
/// becomes PinholeCamera::shrunk(scale): image corners stay where they are, and of the right and
/// bottom border what does not fill a pixel is left out.
/// Cost: O(pixels); deterministic.
#pragma once

#include "tm/views/cameras/view.h"

namespace transformesh {

/// Throws UsageError for a scale below 1 or so large that no pixel is left.
GrayImage at_scale(const GrayImage& image, double scale);

/// Image, camera and silhouette, which keeps its levels at scale 1.
View at_scale(const View& view, double scale);

}  // namespace transformesh
