/// The box in which an object with these silhouettes must lie.
#pragma once

#include <span>

#include "tm/mesh/measure.h"
#include "tm/views/cameras/view.h"

namespace transformesh {

/// The smallest box around all points that lie before every camera and project into the bounding
/// rectangle of every silhouette, one pixel wider. A side of a rectangle that lies on the border of
/// its image bounds nothing, as the object may go on beyond it. Views without silhouette count as
/// cameras that have the object before them. A linear program, solved exactly.
/// Throws InputError, with the name of the view, for a silhouette without a pixel inside; where no
/// point is left, and where the silhouettes do not bound the object on all sides.
Box silhouette_box(std::span<const View> views);

}  // namespace transformesh
