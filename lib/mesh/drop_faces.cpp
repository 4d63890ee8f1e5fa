#include "mesh/drop_faces.h"

#include <utility>

namespace transformesh {

std::size_t drop_faces(Mesh& mesh, const std::vector<char>& is_dropped) {
  std::vector<Face> faces;
  std::vector<Index> rows;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (is_dropped[f]) continue;
    faces.push_back(mesh.faces[f]);
    rows.push_back(f);
  }
  const std::size_t dropped = mesh.faces.size() - faces.size();
  if (dropped > 0) mesh.face_columns = mesh.face_columns.select(rows);
  mesh.faces = std::move(faces);
  return dropped;
}

}  // namespace transformesh
