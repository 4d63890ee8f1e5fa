#include "reconstruction/without_rings.h"

#include <algorithm>

#include "transformesh/components.h"
#include "views/photo/thin_plate.h"

namespace transformesh {

Mesh without_rings(const Mesh& mesh, std::vector<bool> is_marked, int rings) {
  const UniformLaplacian laplacian(mesh);
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<bool> before = is_marked;
    for (Index v = 0; v < before.size(); ++v)
      if (before[v])
        for (const Index neighbor : laplacian.neighbors(v)) is_marked[neighbor] = true;
  }
  std::vector<bool> keeps;
  for (const Face& face : mesh.faces)
    keeps.push_back(std::none_of(face.begin(), face.end(), [&](Index v) { return is_marked[v]; }));
  return select_faces(mesh, keeps);
}

}  // namespace transformesh
