/// The nodes of a glTF scene that have a mesh.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "io/formats/gltf_file.h"

namespace transformesh {

struct GltfInstance {
  std::size_t mesh = 0;
  Eigen::Affine3d to_scene;  ///< from the coordinates of the mesh to those of the scene
};

/// Returns the instances of the default scene, else of the first one, else of all nodes, in the
/// order of a walk that visits parents before children. Throws InputError for a node that is
/// reached twice: the standard allows trees alone, and circles would have no end.
std::vector<GltfInstance> gltf_instances(const GltfFile& file);

}  // namespace transformesh
