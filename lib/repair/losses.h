/// Measures what a step of a repair changed: sizes, the place, and the surface that is gone.
/// Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct Sizes {
  double area = 0, volume = 0;
};
Sizes sizes_of(const Mesh& mesh);

/// Returns for each face whether its middle is not on the other mesh. Cost: O(n log n).
std::vector<char> faces_off(const Mesh& mesh, const Mesh& other);

struct Loss {
  double share = 0;           ///< share of the area of `before`
  Vec3 place = Vec3::Zero();  ///< in the component that lost most
};

/// Returns how much of the surface of a mesh is not in the other one. Cost: O(n log n).
Loss find_loss(const Mesh& before, const Mesh& after);

/// A corner of the first face of one mesh that the other does not have; the origin if there is
/// none.
Vec3 first_change(const Mesh& before, const Mesh& after);

}  // namespace transformesh
