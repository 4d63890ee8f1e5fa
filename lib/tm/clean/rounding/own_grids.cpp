#include "tm/clean/rounding/own_grids.h"

#include <cmath>

namespace transformesh {

Displacement snap_to_own_grids(Mesh& mesh, Scalar type) {
  Displacement displacement;
  for (Vec3& p : mesh.positions) {
    const Vec3 before = p;
    const double spacing = spacing_around(p, type);
    for (double& x : p) x = std::round(x / spacing) * spacing;
    displacement.note((p - before).stableNorm(), spacing);
  }
  return displacement;
}

}  // namespace transformesh
