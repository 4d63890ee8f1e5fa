/// What of an image a mesh covers.
#pragma once

#include "tm/picture/rasterize.h"
#include "tm/views/images/gray_image.h"

namespace transformesh {

/// 255 where the centre of a pixel sees the mesh, else 0. Cost and determinism as of rasterize.
GrayImage mesh_silhouette(const Mesh& mesh, const Camera& camera);

}  // namespace transformesh
