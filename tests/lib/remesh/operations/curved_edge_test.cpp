// Points between the vertices of a mesh, compared with the surfaces on which the vertices lie.
#include "remesh/operations/curved_edge.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "remesh/halfedges/vertex_role.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// The largest distances from a surface of the midpoints of edges, on chords and on curves.
struct Distances {
  double chord = 0;
  double curve = 0;
};

using Surface = std::function<double(const Vec3&)>;  // distance of a point from the surface

Distances distances_of(const EditableMesh& mesh, const Surface& distance) {
  Distances result;
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    if (mesh.is_border(h) || mesh.opposite(h) < h) continue;
    const Vec3& a = mesh.position(mesh.source(h));
    const Vec3& b = mesh.position(mesh.target(h));
    result.chord = std::max(result.chord, std::abs(distance(0.5 * a + 0.5 * b)));
    result.curve = std::max(result.curve, std::abs(distance(curved_midpoint(mesh, h))));
  }
  return result;
}

double from_unit_sphere(const Vec3& p) { return p.norm() - 1; }

/// A grid whose inner vertices are moved at random in the plane, then lifted onto z(x, y).
Mesh lifted_grid(int n, const std::function<double(double, double)>& z) {
  test::Random random(7);
  Mesh mesh = grid(n);
  for (Vec3& p : mesh.positions) {
    const bool is_inner = p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1;
    if (is_inner) p += Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0) / n;
    p.z() = z(p.x(), p.y());
  }
  return mesh;
}

}  // namespace

TEST_CASE("curved midpoints of a sphere converge with the fourth power of the edges") {
  const Distances coarse = distances_of(EditableMesh(icosphere(3)), from_unit_sphere);
  const Distances fine = distances_of(EditableMesh(icosphere(4)), from_unit_sphere);
  CHECK(coarse.curve < 0.1 * coarse.chord);
  CHECK(coarse.chord / fine.chord == doctest::Approx(4).epsilon(0.1));
  CHECK(coarse.curve > 10 * fine.curve);
}

TEST_CASE("curved midpoints of a quadric over an irregular mesh lie on it") {
  const auto saddle = [](double x, double y) { return 0.3 * x * x - 0.2 * x * y - 0.25 * y * y; };
  const EditableMesh mesh(lifted_grid(12, saddle));
  const Distances found =
      distances_of(mesh, [&](const Vec3& p) { return p.z() - saddle(p.x(), p.y()); });
  CHECK(found.chord > 4e-4);
  CHECK(found.curve < 0.1 * found.chord);
}

TEST_CASE("midpoints of flat faces and of their sharp edges stay on them, exactly") {
  EditableMesh mesh(cube());
  for (Index h = 0; h < mesh.halfedge_slots(); ++h) {
    const Vec3 chord = 0.5 * mesh.position(mesh.source(h)) + 0.5 * mesh.position(mesh.target(h));
    CHECK(curved_midpoint(mesh, h) == chord);
  }
}

TEST_CASE("midpoints of a cylinder's crease lie on its circle, and those of its side on the side") {
  constexpr int around = 40;
  constexpr double pi = 3.14159265358979323846;
  Mesh mesh;
  for (int i = 0; i < around; ++i)
    for (const double z : {0.0, 0.15})
      mesh.positions.emplace_back(std::cos(2 * pi * i / around), std::sin(2 * pi * i / around), z);
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, 0.15);
  for (Index i = 0; i < around; ++i) {
    const Index a = 2 * i, b = 2 * ((i + 1) % around);
    mesh.faces.push_back({a, b, b + 1});
    mesh.faces.push_back({a, b + 1, a + 1});
    mesh.faces.push_back({2 * around, b, a});
    mesh.faces.push_back({2 * around + 1, a + 1, b + 1});
  }
  const EditableMesh edited(mesh);
  const double sagitta = 1 - std::cos(pi / around);
  for (Index h = 0; h < edited.halfedge_slots(); ++h) {
    const Index source = edited.source(h), target = edited.target(h);
    if (std::max(source, target) >= 2 * around) continue;
    const Vec3 middle = curved_midpoint(edited, h);
    const double radius = std::sqrt(middle.x() * middle.x() + middle.y() * middle.y());
    const bool is_upright = source / 2 == target / 2;
    const bool is_level = source % 2 == target % 2;
    // Two rings of vertices do not determine how much a diagonal bends, only that it does.
    CHECK(std::abs(radius - 1) < (is_upright ? 1e-12 : (is_level ? 0.05 : 0.5) * sagitta));
    const double z = edited.position(source).z() + edited.position(target).z();
    CHECK(middle.z() == doctest::Approx(z / 2).epsilon(1e-9));
  }
}

TEST_CASE("a vertex that slides on a sphere stays on it, where the plane would leave it") {
  const EditableMesh mesh(icosphere(3));
  double plane = 0, lifted = 0;
  for (Index v = 0; v < mesh.vertex_slots(); ++v) {
    const Vec3 center = mesh.position(v);
    const Vec3 along = center.unitOrthogonal();
    const Vec3 target = center + 0.04 * along;
    plane = std::max(plane, std::abs(from_unit_sphere(target)));
    lifted = std::max(lifted, std::abs(from_unit_sphere(lifted_onto_surface(mesh, v, target))));
  }
  CHECK(plane > 7e-4);
  CHECK(lifted < 0.1 * plane);
}
