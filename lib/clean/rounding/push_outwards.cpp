#include "clean/rounding/push_outwards.h"

#include <limits>

#include "clean/rounding/local_distance.h"

namespace transformesh {
namespace {

/// The least cosine to the normals of all faces for which a direction leads outside.
constexpr double least_outside = 1e-9;

// The step of a grid with these spacings that leads farthest outside of all planes with these
// normals, or none.
Vec3 step_outside(std::vector<Vec3> normals, const Vec3& spacings) {
  const Vec3 shares = spacings / spacings.maxCoeff();
  if (shares.minCoeff() < 1)
    for (Vec3& normal : normals) normal = normal.cwiseProduct(shares).stableNormalized();
  Vec3 best = Vec3::Zero();
  double farthest = least_outside;
  for (int i = 0; i < 27; ++i) {
    const Vec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    double outside = std::numeric_limits<double>::infinity();
    for (const Vec3& normal : normals) outside = std::min(outside, normal.dot(step));
    if (outside <= farthest || normals.empty()) continue;
    farthest = outside;
    best = step;
  }
  return best;
}

// Per position the normals of the faces at it. Positions that are to stay get none.
std::vector<std::vector<Vec3>> normals_at(const Assembly& assembly, const CornerPositions& corners,
                                          bool moves_input) {
  const Mesh& mesh = assembly.mesh;
  std::vector<std::vector<Vec3>> normals(corners.positions().size());
  std::vector<char> stays(normals.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) {
      const Index found = corners.find(mesh.positions[v]);
      if (found == no_index) continue;
      if (!assembly.vertex_is_new[v] && !moves_input) stays[found] = 1;
      const Vec3 normal = unit_normal(triangle_of(mesh, f));
      if (!normal.isZero(0)) normals[found].push_back(normal);
    }
  }
  for (std::size_t i = 0; i < stays.size(); ++i)
    if (stays[i]) normals[i].clear();
  return normals;
}

}  // namespace

Displacement push_outwards(Assembly& assembly, const std::vector<Index>& faces,
                           const MoveRule& rule, const Spacings& spacing) {
  const CornerPositions corners(assembly.mesh, faces);
  const std::vector<std::vector<Vec3>> normals = normals_at(assembly, corners, rule.moves_input);
  const std::vector<Vec3> spacings = corners.spacings(assembly.mesh, faces, spacing);
  std::vector<Vec3> moved = corners.positions();
  Displacement displacement;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Vec3 step =
        rule.spacings * spacings[i].cwiseProduct(step_outside(normals[i], spacings[i]));
    const Vec3 to = rounded_to(moved[i] + step, spacing.type);
    if (!to.allFinite()) continue;
    displacement.note((to - moved[i]).stableNorm(), spacing_around(moved[i], spacing.type));
    moved[i] = to;
  }
  if (displacement.length > 0) corners.move(assembly, moved);
  return displacement;
}

}  // namespace transformesh
