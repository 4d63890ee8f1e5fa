#include "clean/rounding/vertex_grids.h"

#include <cmath>

namespace transformesh {

Displacement snap_to_vertex_grids(Mesh& mesh, Scalar type, double coarser) {
  Displacement displacement;
  for (Vec3& p : mesh.positions) {
    const Vec3 before = p;
    const double spacing = spacing_around(p, type);
    const double step = coarser * spacing;
    for (double& x : p) x = std::round(x / step) * step;
    displacement.note((p - before).stableNorm(), spacing);
  }
  return displacement;
}

}  // namespace transformesh
