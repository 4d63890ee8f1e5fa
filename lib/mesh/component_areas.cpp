#include "mesh/component_areas.h"

#include "transformesh/measure.h"

namespace transformesh {

std::vector<double> component_areas(const Mesh& mesh, const Components& parts) {
  std::vector<double> areas(parts.components.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) areas[parts.of_face[f]] += face_area(mesh, f);
  return areas;
}

}  // namespace transformesh
