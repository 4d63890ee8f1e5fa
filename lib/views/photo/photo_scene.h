/// Calibrated photographs for photometric refinement of a surface, as in Zaharescu, Boyer & Horaud
/// (TPAMI 33(4), 2011, section 5.3.1). They are shrunk by a common factor. The scene also lists the
/// pairs of views to compare.
#pragma once

#include <span>
#include <vector>

#include "views/cameras/view.h"
#include "views/cameras/view_pairs.h"

namespace transformesh {

struct PhotoScene {
  std::vector<View> views;  ///< reduced photographs and their cameras, without silhouettes
  /// For each view, the signed distances of pixels from the contour of its silhouette; empty for
  /// views without silhouette.
  std::vector<PackableImage> distances;
  std::vector<ViewPair> pairs;
  /// Median length of a pixel's side at the point at which the cameras look; input units.
  double pixel = 0;
};

/// Shrinks views by `scale` (at_scale) and chooses the pairs to compare (choose_pairs). Throws
/// InputError if there is no such pair, UsageError as at_scale() does. O(pixels). Parallel over
/// views; the result does not depend on the number of threads. If the images of `views` are packed
/// (packable_image.h), those of the scene are packed, too. The scene then takes 2 bytes per pixel,
/// or 3 if photographs have fractional intensities.
PhotoScene photo_scene(std::span<const View> views, double scale, const PairOptions& pairs = {});

/// Returns the same scene as photo_scene(), but clears images and silhouettes of `views` as early
/// as possible, to save memory.
PhotoScene take_photo_scene(std::span<View> views, double scale, const PairOptions& pairs = {});

}  // namespace transformesh
