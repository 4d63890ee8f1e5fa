/// Converts segments to faces, so that they are drawn as lines of constant width and are occluded
/// by faces in front of them.
#pragma once

#include <span>
#include <utility>

#include "raster/camera.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Appends two faces for each segment: a ribbon that is `width` pixels wide in the image of the
/// camera. The ribbon is also moved towards the camera by this width, so that it is visible on a
/// surface that contains the segment. Skips segments that reach behind the camera or project to a
/// point. Columns do not change. Cost: O(segments).
void add_ribbons(std::span<const std::pair<Vec3, Vec3>> segments, const Camera& camera,
                 double width, Mesh& mesh);

}  // namespace transformesh
