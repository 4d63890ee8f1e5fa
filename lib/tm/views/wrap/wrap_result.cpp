#include "tm/views/wrap/wrap_result.h"

#include <utility>

#include "tm/mesh/manifold.h"
#include "tm/mesh/measure.h"
#include "tm/support/error.h"

namespace transformesh {

void check_wrap(Mesh& mesh) {
  const ManifoldReport report = check_manifold(mesh);
  const bool is_sound = report.is_manifold() && report.is_oriented() && report.is_closed();
  if (mesh.faces.empty() || !is_sound)
    throw GoalError(
        "no closed surface fits these points: do their normals point outwards, or are some far "
        "off?");
  if (volume(mesh) >= 0) return;
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
}

}  // namespace transformesh
