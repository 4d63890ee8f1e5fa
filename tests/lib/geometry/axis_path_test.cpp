/// Changes of the winding number along paths, compared with sums of solid angles.
#include "geometry/axis_path.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include "helpers/arrangement_facts.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"

using namespace transformesh;

namespace {

std::optional<int> change(const Mesh& mesh, const Vec3& from, const Vec3& to) {
  AxisPath path(from, to);
  for (Index f = 0; f < mesh.faces.size(); ++f) path.add(triangle_of(mesh, f));
  return path.change();
}

Vec3 far_along_x(Vec3 point) {
  point.x() = std::numeric_limits<double>::infinity();
  return point;
}

}  // namespace

TEST_CASE("the change between two points is that of solid angles") {
  test::Random random(7);
  std::set<int> seen;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Mesh mesh = test::random_balls(seed, 5);
    for (int i = 0; i < 60; ++i) {
      const Vec3 from = random.point(-1, 1), to = random.point(-1, 1);
      const double w_from = test::winding_number(mesh, from), w_to = test::winding_number(mesh, to);
      const auto found = change(mesh, from, to);
      REQUIRE(found);
      CHECK(*found == std::lround(w_to) - std::lround(w_from));
      CHECK(change(mesh, from, far_along_x(from)) == -std::lround(w_from));
      seen.insert(*found);
    }
  }
  CHECK(seen.size() > 3);
}

TEST_CASE("a path that meets an edge, a corner or a face at its end is uncertain") {
  const Mesh cube = test::cube();
  CHECK(change(cube, {.5, .25, .3}, {5, .25, .3}) == -1);
  // The path goes through the diagonal of a side.
  CHECK(change(cube, {.5, .5, .5}, {5, .5, .5}) == std::nullopt);
  CHECK(change(cube, {.5, 0, .25}, {5, 0, .25}) == std::nullopt);    // the path lies in a side
  CHECK(change(cube, {.5, .25, .3}, {1, .25, .3}) == std::nullopt);  // the path ends on a side
  CHECK(change(cube, {.5, .25, .3}, {.75, .25, .3}) == 0);
  CHECK(change(cube, {-3, 0, 0}, {-2, 0, 0}) == 0);
  CHECK(change(cube, {.5, .5, .5}, far_along_x({.5, .5, .5})) == std::nullopt);
}

TEST_CASE("faces without area change nothing, even where a path meets them") {
  Mesh mesh = test::cube();
  const auto v = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{.7, 0, .3}, {.7, 1, .3}, {.7, .5, .3}});
  mesh.faces.push_back({v, v + 1, v + 2});
  CHECK(change(mesh, {.5, .25, .3}, {5, .25, .3}) == -1);
}

TEST_CASE("points of a box are inside of it, and all different along each axis") {
  const Eigen::AlignedBox3d box(Vec3(-1e308, 2, 0), Vec3(1e308, 3, 1e-300));
  std::array<std::set<double>, 3> coordinates;
  for (int i = 0; i < 100; ++i) {
    const Vec3 point = spread_point(box, i);
    CHECK(box.contains(point));
    for (std::size_t k = 0; k < 3; ++k) coordinates[k].insert(point[static_cast<Eigen::Index>(k)]);
  }
  for (const auto& values : coordinates) CHECK(values.size() == 100);
}
