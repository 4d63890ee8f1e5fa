/// Compares the outline of a surface with the masks of its photographs.
#pragma once

#include <vector>

#include "transformesh/mesh.h"
#include "views/photo/photo_scene.h"

namespace transformesh {

/// Returns the intersection over union of outline and mask in each view that has a mask. Derives
/// the masks from PhotoScene::distances, because the silhouettes of the views may have been
/// cleared.
std::vector<double> outline_agreements(const Mesh& mesh, const PhotoScene& scene);

}  // namespace transformesh
