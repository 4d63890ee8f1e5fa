#include "tm/remesh/degenerate.h"

#include <algorithm>

namespace transformesh {
namespace {

constexpr double least_height = 1e-3;  ///< of the longest edge
constexpr double short_edge = 0.1;     ///< of the longest edge: a needle
constexpr int most_rounds = 4;

Index longest_halfedge(const EditableMesh& mesh, Index face) {
  Index longest = 3 * face;
  for (Index h = 3 * face + 1; h < 3 * face + 3; ++h) {
    if (mesh.squared_length(h) > mesh.squared_length(longest)) longest = h;
  }
  return longest;
}

Index shortest_halfedge(const EditableMesh& mesh, Index face) {
  Index shortest = 3 * face;
  for (Index h = 3 * face + 1; h < 3 * face + 3; ++h) {
    if (mesh.squared_length(h) < mesh.squared_length(shortest)) shortest = h;
  }
  return shortest;
}

bool is_degenerate(const EditableMesh& mesh, Index face) {
  // twice the area is longest edge times height
  const double longest = mesh.squared_length(longest_halfedge(mesh, face));
  return mesh.face_normal(face).squaredNorm() <= least_height * least_height * longest * longest;
}

std::vector<Index> degenerate_faces(const EditableMesh& mesh) {
  std::vector<Index> faces;
  for (Index face = 0; face < mesh.face_slots(); ++face) {
    if (mesh.has_face(face) && is_degenerate(mesh, face)) faces.push_back(face);
  }
  return faces;
}

}  // namespace

std::size_t count_degenerate_faces(const EditableMesh& mesh) {
  return degenerate_faces(mesh).size();
}

std::size_t remove_degenerate_faces(EditableMesh& mesh, EmbeddingGuard& guard,
                                    const VertexRoles& roles, double max_edge) {
  std::vector<Index> faces = degenerate_faces(mesh);
  for (int round = 0; round < most_rounds && !faces.empty(); ++round) {
    bool changed = false;
    for (const Index face : faces) {
      if (!mesh.has_face(face) || !is_degenerate(mesh, face)) continue;
      const Index longest = longest_halfedge(mesh, face);
      const Index shortest = shortest_halfedge(mesh, face);
      const bool is_needle =
          mesh.squared_length(shortest) < short_edge * short_edge * mesh.squared_length(longest);
      const bool may_collapse = !(roles.keeps_border() && mesh.is_border(shortest));
      changed |= is_needle && may_collapse
                     ? collapse_edge(mesh, guard, roles, shortest, max_edge) ||
                           flip_edge(mesh, guard, longest)
                     : flip_edge(mesh, guard, longest);
    }
    if (!changed) break;
    faces = degenerate_faces(mesh);
  }
  return count_degenerate_faces(mesh);
}

}  // namespace transformesh
