#include "mesh/mesh_of_faces.h"

namespace transformesh {

Mesh mesh_of_faces(const Mesh& mesh, const std::vector<Index>& faces) {
  Mesh part;
  std::vector<Index> number(mesh.positions.size(), no_index);
  for (const Index f : faces) {
    Face face = mesh.faces[f];
    for (Index& vertex : face) {
      Index& known = number[vertex];
      if (known == no_index) {
        known = static_cast<Index>(part.positions.size());
        part.positions.push_back(mesh.positions[vertex]);
      }
      vertex = known;
    }
    part.faces.push_back(face);
  }
  return part;
}

}  // namespace transformesh
