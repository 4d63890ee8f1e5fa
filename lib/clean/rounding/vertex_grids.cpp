#include "clean/rounding/vertex_grids.h"

#include <algorithm>
#include <cmath>

namespace transformesh {

VertexGrids::VertexGrids(const Assembly& assembly, Scalar type)
    : type_(type), levels_(assembly.mesh.positions.size(), 0) {}

double VertexGrids::step(const Mesh& mesh, Index vertex) const {
  return std::ldexp(spacing_around(mesh.positions[vertex], type_), levels_[vertex] - 1);
}

std::vector<std::uint8_t> VertexGrids::levels_of_faces(const Mesh& mesh) const {
  std::vector<std::uint8_t> levels;
  levels.reserve(mesh.faces.size());
  for (const auto& [a, b, c] : mesh.faces)
    levels.push_back(std::max({levels_[a], levels_[b], levels_[c]}));
  return levels;
}

void VertexGrids::coarsen(const Mesh& mesh, const std::vector<Index>& faces) {
  std::vector<char> is_corner(levels_.size(), 0);
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) is_corner[v] = 1;
  for (std::size_t v = 0; v < levels_.size(); ++v) {
    if (!is_corner[v]) continue;
    ++levels_[v];
    largest_level_ = std::max(largest_level_, levels_[v]);
  }
}

bool VertexGrids::snap(Assembly& assembly, const std::vector<Index>& faces, bool moves_input,
                       Displacement& moved) const {
  Mesh& mesh = assembly.mesh;
  std::vector<char> is_moved(mesh.positions.size(), 0);
  Displacement most;
  for (const Index face : faces)
    for (const Index v : mesh.faces[face]) {
      if (is_moved[v] || levels_[v] == 0 || !(moves_input || assembly.vertex_is_new[v])) continue;
      const double size = step(mesh, v);
      const Vec3 from = mesh.positions[v], to = (from / size).array().round() * size;
      if (to == from || !to.allFinite()) continue;
      most.note((to - from).stableNorm(), spacing_around(from, type_));
      mesh.positions[v] = to;
      is_moved[v] = assembly.vertex_is_new[v] = 1;
    }
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const Index v : mesh.faces[f])
      if (is_moved[v]) assembly.face_is_new[f] = 1;
  moved += most;
  return most.length > 0;
}

void VertexGrids::inherit(const Mesh& before, const Assembly& after) {
  const std::vector<std::uint8_t> of_faces = levels_of_faces(before);
  std::vector<std::uint8_t> levels(after.mesh.positions.size(), 0);
  for (Index f = 0; f < after.mesh.faces.size(); ++f)
    for (const Index v : after.mesh.faces[f])
      levels[v] = std::max(levels[v], of_faces[after.source_face[f]]);
  for (std::size_t v = 0; v < levels.size(); ++v)
    if (after.input_vertex[v] != no_index) levels[v] = levels_[after.input_vertex[v]];
  levels_ = std::move(levels);
}

}  // namespace transformesh
