#include "remesh/guards/exact_guard.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

bool boxes_touch(const Triangle& s, const Triangle& t) {
  for (int i = 0; i < 3; ++i) {
    const auto [s_low, s_high] = std::minmax({s[0][i], s[1][i], s[2][i]});
    const auto [t_low, t_high] = std::minmax({t[0][i], t[1][i], t[2][i]});
    if (s_high < t_low || t_high < s_low) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("the guard finds all faces near, also after faces were divided") {
  EditableMesh mesh(icosphere(2));
  ExactGuard guard(mesh);
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const auto halfedge = static_cast<Index>(random.below(mesh.halfedge_slots()));
    const Index face = halfedge / 3;
    const Index across = mesh.opposite(halfedge) / 3;
    const Index half = mesh.face_slots();
    const Vec3 middle =
        0.5 * mesh.position(mesh.source(halfedge)) + 0.5 * mesh.position(mesh.target(halfedge));
    mesh.split(halfedge, middle);
    guard.divide(face, std::array{face, half});
    guard.divide(across, std::array{across, half + 1});
  }
  for (int i = 0; i < 50; ++i) {
    const Vec3 at = random.point(-1, 1);
    const Triangle triangle{at, at + random.point(-0.3, 0.3), at + random.point(-0.3, 0.3)};
    std::set<Index> found;
    guard.for_each_near(triangle, [&](Index face) { return found.insert(face).second; });
    for (Index face = 0; face < mesh.face_slots(); ++face)
      if (boxes_touch(triangle, mesh.triangle(face))) REQUIRE(found.count(face) == 1);
  }
}

TEST_CASE("triangles with new intersections are refused") {
  // A square in the plane z = 0 and a triangle above it.
  Mesh above;
  above.positions = {{0.2, 0.2, 0.1}, {0.8, 0.2, 0.1}, {0.5, 0.8, 0.1}};
  above.faces = {{0, 1, 2}};
  const Mesh both = joined(grid(1), above);
  EditableMesh mesh(both);
  const ExactGuard guard(mesh);
  const std::array<Index, 1> replaced{2};
  const auto lowered = [&](double depth) {
    Triangle triangle = mesh.triangle(2);
    triangle[2].z() -= depth;
    return std::array<Triangle, 1>{triangle};
  };
  CHECK(guard.allows(lowered(0.05), replaced));
  CHECK_FALSE(guard.allows(lowered(0.1), replaced));
  CHECK_FALSE(guard.allows(lowered(0.2), replaced));
  const std::array<Triangle, 1> flat{Triangle{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(2, 0, 1)}};
  CHECK_FALSE(guard.allows(flat, replaced));
}
