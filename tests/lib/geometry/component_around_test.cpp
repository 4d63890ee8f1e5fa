/// Points in, on and around bodies for which the component is known.
#include "geometry/component_around.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

/// Nested balls of radius 1 to 3, the middle one inside out, and a box beside them.
Mesh nested() {
  const auto ball = [](double radius) {
    Mesh mesh = test::icosphere(2);
    for (Vec3& position : mesh.positions) position *= radius;
    return mesh;
  };
  Mesh mesh = test::joined(ball(3), test::reversed(ball(2)));
  mesh = test::joined(mesh, ball(1));
  return test::joined(mesh, test::cuboid({5, 0, 0}, {6, 1, 1}));
}

/// The number of the chosen component, and whether it contains the point.
std::pair<Index, bool> found_at(const Mesh& mesh, const Vec3& point) {
  const ComponentAround found = component_around(mesh, point);
  const Components all = connected_components(mesh);
  const auto first = std::find(found.faces.begin(), found.faces.end(), true);
  const Index component = all.of_face[static_cast<std::size_t>(first - found.faces.begin())];
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    CHECK(found.faces[f] == (all.of_face[f] == component));
  return {component, found.contains_point};
}

using Found = std::pair<Index, bool>;

}  // namespace

TEST_CASE("of nested components the innermost that contains the point is taken") {
  const Mesh mesh = nested();
  CHECK(found_at(mesh, {0, 0, 0}) == Found(2, true));
  CHECK(found_at(mesh, {0, 0, 1.1}) == Found(1, true));  // the ball of radius 1 is closer
  CHECK(found_at(mesh, {0, 2.1, 0}) == Found(0, true));
  CHECK(found_at(mesh, {5.5, 0.5, 0.5}) == Found(3, true));
  CHECK(found_at(mesh, {4.9, 0.5, 0.5}) == Found(3, false));
  CHECK(found_at(mesh, {0, 0, 7}) == Found(0, false));
  CHECK(component_around(mesh, {7, 0.5, 0.5}).distance == doctest::Approx(1));
}

TEST_CASE("a component through the point contains it") {
  const Mesh mesh = nested();
  CHECK(found_at(mesh, mesh.positions[3]) == Found(0, true));
  CHECK(found_at(mesh, {5, 0.25, 0.25}) == Found(3, true));
  CHECK(found_at(mesh, {5, 0.5, 0.5}) == Found(3, true));
}

TEST_CASE("a component with a small hole contains what is inside, an open sheet nothing") {
  Mesh mesh = test::icosphere(2);
  mesh.faces.pop_back();
  CHECK(found_at(mesh, {0.1, 0.2, 0.3}) == Found(0, true));
  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.faces = {{0, 1, 2}};
  CHECK(found_at(sheet, {0.3, 0.3, 1e-6}) == Found(0, false));
}

TEST_CASE("meshes of any size have a component around a point, and empty ones have none") {
  for (const double size : {1e-300, 1e-150, 1e150, 1e300}) {
    Mesh mesh = nested();
    for (Vec3& position : mesh.positions) position *= size;
    CHECK(found_at(mesh, {0, 0, 1.1 * size}) == Found(1, true));
    CHECK(found_at(mesh, {4.9 * size, 0, 0}) == Found(3, false));
  }
  CHECK_THROWS_AS(component_around(Mesh(), {0, 0, 0}), InputError);
}
