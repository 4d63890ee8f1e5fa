#include "remesh/operations/smooth.h"

#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

template <class Step>
Mesh after(const Mesh& mesh, const Step& step) {
  EditableMesh editable(mesh);
  EmbeddingGuard guard(editable, 0);
  const VertexRoles roles(editable, false);
  step(editable, guard, roles);
  return editable.to_mesh();
}

Mesh smoothed(const Mesh& mesh, double first, double second = 0) {
  return after(mesh, [&](EditableMesh& editable, EmbeddingGuard& guard, const VertexRoles& roles) {
    smooth_laplace(editable, guard, roles, first, second, {});
  });
}

double mean_radius(const Mesh& mesh) {
  double sum = 0;
  for (const Vec3& p : mesh.positions) sum += p.norm();
  return sum / static_cast<double>(mesh.positions.size());
}

}  // namespace

TEST_CASE("the regular octahedron shrinks by exactly the factor") {
  // The neighbors of each vertex v are the four vertices around the origin in the plane
  // perpendicular to v, with equal weights. Hence v minus their mean is dv = v.
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const Mesh once = smoothed(mesh, 0.1);
  for (std::size_t v = 0; v < 6; ++v) {
    CHECK((once.positions[v] - 0.9 * mesh.positions[v]).norm() < 1e-15);
  }
  // The first operator gives dv = v for all vertices, so the second operator gives d2v = v, too.
  const Mesh twice = smoothed(mesh, 0.1, 0.04);
  for (std::size_t v = 0; v < 6; ++v) {
    CHECK((twice.positions[v] - 0.94 * mesh.positions[v]).norm() < 1e-15);
  }
}

TEST_CASE("a plane has no Laplacian, whatever its triangles without wide angles") {
  Mesh mesh = grid(8);
  Random random(1);
  for (Vec3& point : mesh.positions) {
    const bool inside = point.x() > 0 && point.x() < 1 && point.y() > 0 && point.y() < 1;
    if (inside) point += Vec3(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), 0);
    point = Vec3(point.x() - 0.5 * point.y(), std::sqrt(0.75) * point.y(), 0);
  }
  const Mesh smooth = smoothed(mesh, 0.5);
  double largest = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    largest = std::max(largest, (smooth.positions[v] - mesh.positions[v]).norm());
  }
  CHECK(largest < 1e-12);
}

TEST_CASE("noise shrinks under the Laplacian") {
  Mesh mesh = icosphere(4);
  Random random(2);
  for (Vec3& point : mesh.positions) point *= random.uniform(0.99, 1.01);
  const auto roughness = [](const Mesh& m) {
    const double mean = mean_radius(m);
    double sum = 0;
    for (const Vec3& p : m.positions) sum += (p.norm() - mean) * (p.norm() - mean);
    return std::sqrt(sum / static_cast<double>(m.positions.size()));
  };
  CHECK(roughness(smoothed(mesh, 0.5)) < 0.6 * roughness(mesh));
  // The second operator alone reduces noise as well, and changes the radius less.
  CHECK(roughness(smoothed(mesh, 0, -0.4)) < 0.7 * roughness(mesh));
  CHECK(std::abs(mean_radius(smoothed(mesh, 0, -0.4)) - mean_radius(mesh)) <
        std::abs(mean_radius(smoothed(mesh, 0.5)) - mean_radius(mesh)));
}

TEST_CASE("slivers do not explode") {
  Mesh mesh = icosphere(3);
  const Face face = mesh.faces[50];
  mesh.positions[face[0]] =
      0.5 * (mesh.positions[face[1]] + mesh.positions[face[2]]) + Vec3(1e-12, 0, 0);
  const Mesh smooth = smoothed(mesh, 0.9);
  for (const Vec3& p : smooth.positions) {
    CHECK(p.allFinite());
    CHECK(p.norm() < 1.01);
  }
}

TEST_CASE("relaxation keeps the volume to rounding and rounds the triangles") {
  Mesh mesh = icosphere(3);
  Random random(3);
  for (Vec3& point : mesh.positions) point = (point + random.point(-0.03, 0.03)).normalized();
  const Mesh relaxed =
      after(mesh, [](EditableMesh& editable, EmbeddingGuard& guard, const VertexRoles& roles) {
        CHECK(relax_tangentially(editable, guard, roles, nullptr, {}).moved > 600);
      });
  CHECK(volume(relaxed) == doctest::Approx(volume(mesh)).epsilon(1e-12));
  CHECK(angles(relaxed).minimum_mean_deg > angles(mesh).minimum_mean_deg + 3);
}
