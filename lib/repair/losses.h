/// Measures how a step of a repair changed a mesh: area and volume, the first changed place, and
/// the share of the surface that was removed. Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct Sizes {
  double area = 0, volume = 0;
};
/// Returns the area of a mesh and the volume of its closed components.
Sizes sizes_of(const Mesh& mesh);

/// Returns 1 for each face of `mesh` whose centroid does not lie on `other`. Cost: O(n log n).
std::vector<char> faces_off(const Mesh& mesh, const Mesh& other);

struct Loss {
  double share = 0;           ///< lost area / area of `before`, in [0, 1]
  Vec3 place = Vec3::Zero();  ///< corner of a lost face in the component that lost the most area
};

/// Returns the loss: the surface of `before` that is missing in `after`. Cost: O(n log n).
Loss find_loss(const Mesh& before, const Mesh& after);

/// Returns the position of the first corner, in the order of the faces, at which the two meshes
/// differ. Returns the origin if they do not differ.
Vec3 first_change(const Mesh& before, const Mesh& after);

}  // namespace transformesh
