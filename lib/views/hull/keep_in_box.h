/// Views of nothing but what is in a box: for photographs with clutter around the object.
#pragma once

#include <vector>

#include "transformesh/measure.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Where a view shows nothing of the box, and a pixel around it neither, its photograph becomes
/// black and its silhouette the outside; all else stays. Images that are packed are so again.
/// Throws UsageError for a box that is not finite or has no inside, InputError, with the name of
/// the view, where that shows nothing of the box. O(pixels); in parallel over views, deterministic.
void keep_in_box(std::vector<View>& views, const Box& box);

}  // namespace transformesh
