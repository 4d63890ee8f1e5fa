/// Segments as faces, so that they are drawn as lines of one width and hidden by what is before
/// them.
#pragma once

#include <span>
#include <utility>

#include "raster/camera.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Appends two faces for each segment: a ribbon that is `width` pixels wide in the picture of the
/// camera, and as much nearer to the eye, so that it shows on a surface in which it lies.
/// Segments that reach behind the eye, or on which it looks end on, are left out. Columns stay as
/// they are. Cost: O(segments).
void add_ribbons(std::span<const std::pair<Vec3, Vec3>> segments, const Camera& camera,
                 double width, Mesh& mesh);

}  // namespace transformesh
