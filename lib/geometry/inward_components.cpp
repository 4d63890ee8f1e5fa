#include "geometry/inward_components.h"

#include "geometry/numbers/volume_sign.h"

namespace transformesh {

std::vector<char> inward_components(const Mesh& mesh, const Components& parts) {
  std::vector<std::vector<Index>> faces(parts.components.size());
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (parts.components[parts.of_face[f]].boundary_loops == 0)
      faces[parts.of_face[f]].push_back(f);
  std::vector<char> is_inward;
  for (const std::vector<Index>& part : faces)
    is_inward.push_back(!part.empty() && volume_sign(mesh, part) < 0 ? 1 : 0);
  return is_inward;
}

}  // namespace transformesh
