#include "reconstruction/better_parts.h"

#include "geometry/search/closest_point.h"
#include "reconstruction/start_comparison.h"
#include "reconstruction/surface_doubt.h"
#include "views/photo/thin_plate.h"

namespace transformesh {
namespace {

/// Number of rings of neighbors around a vertex on which photographs are compared together. Edges
/// are three pixels long, so that four rings are 25 pixels wide. On this width noise hardly
/// decides.
constexpr int compared_rings = 4;
/// Number of rings of neighbors over which movements decrease to zero.
constexpr int blended_rings = 2;
/// Returns the vertex of a face that is closest to a point.
Index closest_corner(const Mesh& mesh, Index face, const Vec3& point) {
  Index best = mesh.faces[face][0];
  for (const Index vertex : mesh.faces[face])
    if ((mesh.positions[vertex] - point).norm() < (mesh.positions[best] - point).norm())
      best = vertex;
  return best;
}

/// Adds the WindowSums of each vertex of `from` to those of a vertex of `to` that is at most about
/// `reach` away.
std::vector<WindowSums> carried(const MeasuredMesh& from, const Mesh& to, double reach) {
  const ClosestPointQuery closest(to);
  std::vector<WindowSums> sums(to.positions.size());
  for (std::size_t v = 0; v < from.sums.size(); ++v) {
    const Vec3& position = from.mesh.positions[v];
    const Index face = closest.closest_face_within(position, reach);
    if (face != no_index) sums[closest_corner(to, face, position)] += from.sums[v];
  }
  return sums;
}

/// Returns, for each vertex of the result, 1 if it moves back to the initial mesh, else 0.
std::vector<double> returning(const std::vector<WindowSums>& of_result,
                              const std::vector<WindowSums>& of_start) {
  std::vector<double> shares;
  for (std::size_t v = 0; v < of_result.size(); ++v) {
    const bool is_comparable = of_result[v].weight > 0 && of_start[v].weight > 0;
    const bool is_better = is_clearly_less(of_result[v].excess(), of_start[v].excess());
    shares.push_back(is_comparable && !is_better ? 1 : 0);
  }
  return shares;
}

void blend(std::vector<double>& shares, const UniformLaplacian& laplacian) {
  for (int ring = 0; ring < blended_rings; ++ring) {
    const std::vector<double> before = shares;
    for (Index v = 0; v < shares.size(); ++v) {
      double sum = before[v];
      for (const Index neighbor : laplacian.neighbors(v)) sum += before[neighbor];
      shares[v] = sum / static_cast<double>(1 + laplacian.neighbors(v).size());
    }
  }
}

}  // namespace

double restore_better_parts(Mesh& result, const std::vector<WindowSums>& of_result,
                            const MeasuredMesh& start, double reach) {
  const UniformLaplacian laplacian(result);
  std::vector<double> shares =
      returning(spread(of_result, laplacian, compared_rings),
                spread(carried(start, result, reach), laplacian, compared_rings));
  blend(shares, laplacian);
  const ClosestPointQuery closest(start.mesh);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < shares.size(); ++v) {
    if (shares[v] == 0) continue;
    const ClosestPoint found = closest(result.positions[v]);
    if (found.distance > reach) continue;
    result.positions[v] += shares[v] * (found.point - result.positions[v]);
    moved += shares[v] >= 0.5 ? 1 : 0;
  }
  return static_cast<double>(moved) / static_cast<double>(shares.size());
}

}  // namespace transformesh
