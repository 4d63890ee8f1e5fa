/// Makes an Assembly (assemble.h), the result of cleaning before rounding, of a mesh, for tests of
/// rounding.
#pragma once

#include "clean/stitch/assemble.h"

namespace transformesh::test {

/// Returns an assembly in which all vertices and faces are new, and each face is its own source
/// face.
inline Assembly assembly_of(const Mesh& mesh) {
  Assembly assembly;
  assembly.mesh = mesh;
  assembly.vertex_is_new.assign(mesh.positions.size(), 1);
  assembly.input_vertex.assign(mesh.positions.size(), no_index);
  assembly.face_is_new.assign(mesh.faces.size(), 1);
  for (Index f = 0; f < mesh.faces.size(); ++f) assembly.source_face.push_back(f);
  return assembly;
}

inline std::vector<Index> all_faces(const Mesh& mesh) {
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.faces.size(); ++f) faces.push_back(f);
  return faces;
}

}  // namespace transformesh::test
