/// Finds the intensity threshold at which the silhouettes of all photographs agree best.
///
/// The object is bright and the background dark. One photograph alone does not distinguish dark
/// regions of the object from the background, but several photographs do. If a threshold is too
/// high, it cuts parts off the object in some views. The hull then no longer fills the silhouettes
/// of the other views. If a threshold is too low, it adds background to some silhouettes. The hull
/// does not contain this background, because it is outside of the silhouettes of other views.
///
/// The candidates are the threshold that best divides the pixels of all photographs
/// (dividing_threshold) and eight smaller ones, down to a quarter of it. The visual hull of the
/// candidate's silhouettes is projected into each view. The score of a candidate is the
/// intersection over union of its silhouette and the hull's projection, averaged over the views.
/// The result is the highest candidate whose score is at most 0.001 below the best score. The
/// highest is chosen because noise of the background then affects contours less.
#pragma once

#include <span>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/silhouette.h"

namespace transformesh {

/// Returns the threshold. Photographs are shrunk to at most 320 pixels, and hulls have 48 cells
/// along the longest side. Returns dividing_threshold() if no candidate yields a hull. Ignores
/// `options.intensity`. Throws UsageError if no view has an image, and if the other options are out
/// of range (see threshold_silhouette). O(pixels); 2 to 3 s of processor time for 16 views.
/// Parallel; the result does not depend on the number of threads.
double agreed_threshold(std::span<const View> views, const ThresholdOptions& options = {},
                        const Progress& progress = {});

/// Sets the silhouette of every view to the pixels above `options.intensity`, or above
/// agreed_threshold() if `options.intensity` is not given. Every view must have an image. Returns
/// the threshold. Throws what agreed_threshold() and threshold_silhouette() throw.
double threshold_silhouettes(std::vector<View>& views, ThresholdOptions options = {},
                             const Progress& progress = {});

}  // namespace transformesh
