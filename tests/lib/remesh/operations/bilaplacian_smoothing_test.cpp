#include "remesh/operations/bilaplacian_smoothing.h"

#include <algorithm>
#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

Mesh evened(const Mesh& mesh) {
  EditableMesh editable(mesh);
  EmbeddingGuard guard(editable, 0);
  smooth_bilaplacian(editable, guard, VertexRoles(editable, false), {});
  return editable.to_mesh();
}

/// Returns the root mean square deviation of radii from 1.
double roughness(const Mesh& mesh) {
  double sum = 0;
  for (const Vec3& p : mesh.positions) sum += (p.norm() - 1) * (p.norm() - 1);
  return std::sqrt(sum / static_cast<double>(mesh.positions.size()));
}

}  // namespace

TEST_CASE("vertices a little off a sphere come nearer to it, and it does not shrink") {
  const Mesh sphere = icosphere(4);
  CHECK(roughness(evened(sphere)) < 2e-5);  // chords of its edges are 5e-4 inside
  Mesh rough = sphere;
  Random random(7);
  for (Vec3& point : rough.positions) point *= random.uniform(0.998, 1.002);
  const Mesh even = evened(rough);
  CHECK(is_oriented_manifold(even));
  CHECK(roughness(even) < 0.8 * roughness(rough));
  CHECK(std::abs(volume(even) / volume(rough) - 1) < 1e-4);
}

TEST_CASE("planes, creases and what is beside them stay") {
  Mesh roof = grid(8);
  for (Vec3& p : roof.positions) p.z() = -std::abs(p.x() - 0.5);
  CHECK(evened(roof).positions == roof.positions);
}

TEST_CASE("borders stay") {
  Mesh bowl = grid(8);
  for (Vec3& p : bowl.positions) p.z() = 0.1 * p.x() * p.x() + 0.05 * p.y() * p.x() * p.x();
  const Mesh even = evened(bowl);
  for (std::size_t v = 0; v < bowl.positions.size(); ++v) {
    const Vec3& p = bowl.positions[v];
    if (std::min(p.x(), p.y()) == 0 || std::max(p.x(), p.y()) == 1)
      CHECK(even.positions[v] == bowl.positions[v]);
  }
}
