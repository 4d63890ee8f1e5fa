/// Finds parts of a surface that other parts hide from the photographs, such as the bottom of a
/// hollow. A part that no view faces, such as the bottom of an object on a table, is not hidden.
#pragma once

#include <vector>

#include "transformesh/mesh.h"
#include "views/photo/photo_scene.h"

namespace transformesh {

/// Returns true for each unobserved vertex that both views of a pair face and have inside their
/// images. A view faces a vertex if the cosine between ray and normal is above `least_cosine`. Each
/// unobserved vertex takes O(views + pairs).
std::vector<bool> hidden_vertices(const Mesh& mesh, const std::vector<bool>& is_observed,
                                  const PhotoScene& scene, double least_cosine);

}  // namespace transformesh
