/// The intensity at which photographs agree best on what is the object and what the background.
///
/// One image alone does not distinguish dark regions of the object from the background. Together
/// images do: a intensity that is too high cuts into the object in some views, and their hull no
/// longer fills the silhouettes of the others; one that is too low takes the background for the
/// object, which the others carve. The intensity that best divides the pixels of all photographs
/// (dividing_threshold) and smaller ones, down to a quarter of it, are tried. Each is judged by how
/// well its silhouettes agree with those of their visual hull: the mean over the views of
/// intersection over union. The highest of the intensities within 0.001 of the best is taken,
/// because there contours lie farthest from the background's noise.
#pragma once

#include <span>
#include <vector>

#include "support/progress.h"
#include "views/cameras/view.h"
#include "views/hull/silhouette.h"

namespace transformesh {

/// Looks at images of at most 320 pixels, and hulls of 48 cells. Where no intensity gives a hull,
/// it is the dividing intensity. `options.intensity` is not used; throws UsageError as
/// threshold_silhouette does for the others, and where no view has an image. O(pixels); 2 to 3 s of
/// computing for 16 views. Parallel; the same for any number of threads.
double agreed_threshold(std::span<const View> views, const ThresholdOptions& options = {},
                        const Progress& progress = {});

/// Gives every view, which has an image, the silhouette of what is brighter than the intensity, or
/// than the agreed one where options have none. Returns that intensity; throws as both functions
/// do.
double threshold_silhouettes(std::vector<View>& views, ThresholdOptions options = {},
                             const Progress& progress = {});

}  // namespace transformesh
