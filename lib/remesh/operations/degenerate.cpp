#include "remesh/operations/degenerate.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "remesh/halfedges/select_slots.h"

namespace transformesh {
namespace {

/// A face is a needle if its shortest edge is below this share of its longest edge; the shortest
/// edge is then collapsed. The longest edge of other degenerate faces is flipped.
constexpr double short_edge = 0.1;
constexpr int most_collapse_rounds = 4;

/// The shortest and the longest edge of a face.
struct EdgesByLength {
  Index shortest;
  Index longest;
  double shortest_squared;
  double longest_squared;

  EdgesByLength(const EditableMesh& mesh, Index face) : shortest(3 * face), longest(3 * face) {
    shortest_squared = longest_squared = mesh.squared_length(3 * face);
    for (Index h = 3 * face + 1; h < 3 * face + 3; ++h) {
      const double squared = mesh.squared_length(h);
      if (squared < shortest_squared) {
        shortest = h;
        shortest_squared = squared;
      }
      if (squared > longest_squared) {
        longest = h;
        longest_squared = squared;
      }
    }
  }
  bool is_needle() const { return shortest_squared < short_edge * short_edge * longest_squared; }
};

bool is_degenerate(const EditableMesh& mesh, Index face) {
  return FaceShape(mesh, face).is_degenerate();
}

}  // namespace

std::vector<Index> degenerate_faces(const EditableMesh& mesh) {
  return indices_where(mesh.face_slots(), [&](Index face) {
    return mesh.has_face(face) && is_degenerate(mesh, face);
  });
}

std::size_t remove_degenerate_faces(EditableMesh& mesh, EmbeddingGuard& guard,
                                    const VertexRoles& roles, const EdgeLimits& limits) {
  const auto mend = [&](Index face) {
    const EdgesByLength sides(mesh, face);
    const bool may_collapse = !(roles.keeps_border() && mesh.is_border(sides.shortest));
    if (sides.is_needle() && may_collapse &&
        collapse_edge(mesh, guard, roles, sides.shortest, limits)) {
      return true;
    }
    return flip_edge(mesh, guard, sides.longest);
  };
  std::vector<Index> faces = degenerate_faces(mesh);
  for (int round = 0; round < most_collapse_rounds && !faces.empty(); ++round) {
    bool changed = false;
    for (const Index face : faces) {
      if (mesh.has_face(face) && is_degenerate(mesh, face)) changed |= mend(face);
    }
    if (!changed) break;
    faces = degenerate_faces(mesh);
  }
  return faces.size();
}

}  // namespace transformesh
