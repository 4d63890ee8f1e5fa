/// Blackens the parts of photographs and silhouettes outside of the image of a given box in space.
/// Useful for photographs that show other things besides the object.
#pragma once

#include <vector>

#include "transformesh/measure.h"
#include "views/cameras/view.h"

namespace transformesh {

/// Sets pixels of photographs and silhouettes to 0 (black, outside), except for pixels that show
/// the box and their neighbors. Packed images stay packed. Throws UsageError if the box is not
/// finite or has no interior. Throws InputError, with the name of the view, if a view does not show
/// the box. O(pixels); parallel over views, deterministic.
void keep_in_box(std::vector<View>& views, const Box& box);

}  // namespace transformesh
