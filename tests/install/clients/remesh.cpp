// Remeshes a sphere to edges between two lengths and checks volume, counts and edge lengths.
#include <transformesh/remesh.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 1280);
  const RemeshResult result = remesh(mesh, {.min_edge = 0.2, .max_edge = 0.4, .iterations = 5});
  const EdgeLengths edges = edge_lengths(mesh);
  if (result.collapses == 0 || mesh.faces.size() >= 1000) return 1;
  if (edges.mean < 0.2 || edges.mean > 0.4 || edges.maximum > 0.5) return 1;
  if (mesh.positions.size() - mesh.faces.size() / 2 != 2) return 1;
  if (std::abs(volume(mesh) - 4 * std::acos(-1.0) / 3) > 0.3) return 1;
  try {
    remesh(mesh, {.min_edge = 0.4, .max_edge = 0.4});
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
