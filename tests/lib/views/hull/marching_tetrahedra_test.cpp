#include "views/hull/marching_tetrahedra.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "support/parallel.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

template <typename Function>
ValueGrid sampled(std::size_t nodes, const Function& function) {
  ValueGrid grid;
  grid.spacing = 2.0 / static_cast<double>(nodes - 1);
  grid.origin = Vec3::Constant(-1);
  grid.nodes = {nodes, nodes, nodes};
  for (std::size_t z = 0; z < nodes; ++z)
    for (std::size_t y = 0; y < nodes; ++y)
      for (std::size_t x = 0; x < nodes; ++x)
        grid.values.push_back(static_cast<float>(function(
            grid.origin + grid.spacing * Vec3(static_cast<double>(x), static_cast<double>(y),
                                              static_cast<double>(z)))));
  return grid;
}

void check_surface(const Mesh& mesh) {
  const test::Count count = test::count(mesh);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK_FALSE(count.has_isolated_vertices);
  CHECK(find_intersections(mesh).empty());
}

}  // namespace

TEST_CASE("a ball: on the sphere, oriented outwards, of the right size") {
  const auto ball = [](const Vec3& point) {
    return (point - Vec3(0.03, 0.02, -0.01)).norm() - 0.8;
  };
  const Mesh mesh = march_tetrahedra(sampled(41, ball));
  check_surface(mesh);
  CHECK(connected_components(mesh).components.size() == 1);
  for (const Vec3& position : mesh.positions) CHECK(std::abs(ball(position)) < 0.004);
  CHECK(volume(mesh) == doctest::Approx(4.0 / 3 * 3.14159265 * 0.512).epsilon(0.005));
}

TEST_CASE("values at random: still closed, oriented, manifold, without a self-intersection") {
  test::Random random(5);
  for (int round = 0; round < 3; ++round) {
    const ValueGrid grid = sampled(12, [&](const Vec3& point) {
      return point.cwiseAbs().maxCoeff() > 0.95 ? 1.0 : random.uniform(-1, 1);
    });
    const Mesh mesh = march_tetrahedra(grid);
    CHECK(mesh.faces.size() > 1000);
    check_surface(mesh);
  }
}

TEST_CASE("zeros at nodes and huge values do not collapse faces") {
  const ValueGrid grid = sampled(9, [](const Vec3& point) {
    const double far = point.cwiseAbs().maxCoeff();
    return far > 0.9 ? 1e30 : far > 0.7 ? 0.0 : -1e-30;
  });
  const Mesh mesh = march_tetrahedra(grid);
  check_surface(mesh);
  // A cube that extends nearly to the zeros, where edges of the grid lead there.
  CHECK(volume(mesh) < std::pow(2 * (0.5 + 0.95 * 0.25), 3));
  CHECK(volume(mesh) > std::pow(2 * (0.5 + 0.8 * 0.25), 3));
}

TEST_CASE("nothing inside, and the same mesh for any number of threads") {
  CHECK(march_tetrahedra(ValueGrid()).faces.empty());
  CHECK(march_tetrahedra(sampled(5, [](const Vec3&) { return 1.0; })).faces.empty());
  const ValueGrid grid = sampled(31, [](const Vec3& point) { return point.norm() - 0.7; });
  const Mesh several = march_tetrahedra(grid);
  const ThreadLimit one(1);
  const Mesh single = march_tetrahedra(grid);
  CHECK(single.faces == several.faces);
  CHECK(single.positions == several.positions);
}
