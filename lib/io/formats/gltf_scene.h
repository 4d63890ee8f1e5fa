/// Lists the nodes with a mesh in a glTF scene.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "io/formats/gltf_file.h"

namespace transformesh {

struct GltfInstance {
  std::size_t mesh = 0;
  Eigen::Affine3d to_scene;  ///< transformation from mesh coordinates to scene coordinates
};

/// Returns the instances of meshes in the default scene. If there is none, returns those in the
/// first scene; if there are no scenes, those at all nodes. The order is that of a preorder
/// traversal. Throws InputError for a node that is reached twice: the standard allows only trees,
/// and a cycle would not terminate.
std::vector<GltfInstance> gltf_instances(const GltfFile& file);

}  // namespace transformesh
