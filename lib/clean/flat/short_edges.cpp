#include "clean/flat/short_edges.h"

#include <algorithm>
#include <numeric>

#include "clean/rounding/broken_faces.h"
#include "clean/rounding/flat_vertices.h"

namespace transformesh {
namespace {

bool has_short_edge(const Mesh& mesh, Index face, double spacings, Scalar coordinate) {
  const Triangle corners = triangle_of(mesh, face);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &from = corners[i], &to = corners[(i + 1) % 3];
    if ((to - from).stableNorm() <= spacings * spacing_around(from, coordinate)) return true;
  }
  return false;
}

Assembly assembly_of(const Mesh& mesh, const std::vector<char>& has_copy) {
  Assembly assembly;
  assembly.mesh.positions = mesh.positions;
  assembly.mesh.faces = mesh.faces;
  assembly.vertex_is_new = has_copy;
  for (char& is_new : assembly.vertex_is_new) is_new = is_new == 0 ? 1 : 0;
  assembly.face_is_new.assign(mesh.faces.size(), 0);
  assembly.source_face.resize(mesh.faces.size());
  std::iota(assembly.source_face.begin(), assembly.source_face.end(), 0);
  return assembly;
}

/// Removes faces that refer to a vertex twice.
void drop_vanished(Assembly& assembly) {
  std::vector<Face>& faces = assembly.mesh.faces;
  std::size_t count = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [a, b, c] = faces[f];
    if (a == b || b == c || c == a) continue;
    faces[count] = faces[f];
    assembly.face_is_new[count] = assembly.face_is_new[f];
    assembly.source_face[count++] = assembly.source_face[f];
  }
  faces.resize(count);
  assembly.face_is_new.resize(count);
  assembly.source_face.resize(count);
}

}  // namespace

Displacement collapse_short_edges(Mesh& mesh, std::vector<char>& wanted,
                                  const std::vector<char>& has_copy, double spacings,
                                  Scalar coordinate) {
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    if (wanted[f] != 0 && has_short_edge(mesh, f, spacings, coordinate)) faces.push_back(f);
  Displacement moved;
  if (faces.empty()) return moved;
  Assembly assembly = assembly_of(mesh, has_copy);
  const VertexGrids grids(assembly, coordinate);
  // The tolerance of remove_flat_vertices() is in grid steps, and a grid step is half a spacing.
  remove_flat_vertices(mesh, assembly, faces, 2 * spacings, false, grids, moved);
  drop_vanished(assembly);
  if (assembly.mesh.faces.size() == mesh.faces.size() || !find_broken_faces(assembly).faces.empty())
    return {};
  std::vector<char> is_wanted;
  for (std::size_t f = 0; f < assembly.source_face.size(); ++f)
    is_wanted.push_back(assembly.face_is_new[f] | wanted[assembly.source_face[f]] ? 1 : 0);
  wanted = std::move(is_wanted);
  mesh.faces = std::move(assembly.mesh.faces);
  mesh.face_columns = mesh.face_columns.select(assembly.source_face);
  return moved;
}

}  // namespace transformesh
