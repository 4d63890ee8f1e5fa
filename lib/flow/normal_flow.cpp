#include "flow/normal_flow.h"

#include "evolution/miter.h"
#include "mesh/touching_borders.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Returns a convexity measure of each vertex: the sum of the heights of its neighbors over its
/// tangent plane, counted once per face. Negative if the surface is convex at the vertex.
std::vector<double> neighbor_heights(const Mesh& mesh, const std::vector<Vec3>& normals) {
  std::vector<double> heights(mesh.positions.size(), 0);
  for (const Face& face : mesh.faces) {
    const Vec3 sum = mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]];
    for (const Index v : face) heights[v] += (sum - 3 * mesh.positions[v]).dot(normals[v]);
  }
  return heights;
}

}  // namespace

std::vector<Vec3> huygens_velocities(const Mesh& mesh, std::span<const double> speeds) {
  refuse_touching_borders(mesh);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const std::vector<double> heights = neighbor_heights(mesh, normals);
  std::vector<Vec3> velocities = miter_directions(mesh);
  for (std::size_t v = 0; v < velocities.size(); ++v) {
    const bool is_round = speeds[v] > 0 ? heights[v] < 0 : heights[v] > 0;
    velocities[v] = speeds[v] * (is_round ? normals[v] : velocities[v]);
  }
  return velocities;
}

}  // namespace transformesh
