#include "clean/open/component_winding.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

/// A box without its top, which is two triangles.
Mesh open_box(const Vec3& low, const Vec3& high) {
  Mesh mesh = test::cuboid(low, high);
  mesh.faces.erase(mesh.faces.begin() + 2, mesh.faces.begin() + 4);
  return mesh;
}

std::vector<Index> all_pieces(const Arrangement& arrangement) {
  std::vector<Index> pieces(arrangement.pieces.size());
  for (Index p = 0; p < pieces.size(); ++p) pieces[p] = p;
  return pieces;
}

}  // namespace

TEST_CASE("a flat sheet has the number 0 on itself, and is no body") {
  const Arrangement arrangement = test::arranged_open(test::grid(4), std::vector<Index>(32, 0));
  ComponentWinding winding(arrangement);
  CHECK(std::abs(winding.on_itself(0)) < 1e-9);
  CHECK(!winding.is_body(0));
}

TEST_CASE("a ball with a small hole has a number near 1/2 on itself, and is a body") {
  Mesh ball = test::icosphere(3);
  ball.faces.pop_back();
  const Arrangement arrangement =
      test::arranged_open(ball, std::vector<Index>(ball.faces.size(), 0));
  ComponentWinding winding(arrangement);
  CHECK(winding.on_itself(0) == doctest::Approx(.5).epsilon(.02));
  CHECK(winding.is_body(0));
}

TEST_CASE("the number on itself does not depend on how much of the component is hidden") {
  // The small balls are inside out. Their area is larger than that of the large ball with the hole.
  Mesh mesh = test::icosphere(3);
  mesh.faces.pop_back();
  for (int i = 0; i < 20; ++i) {
    const Mesh small = test::reversed(test::scaled(test::icosphere(1), .3));
    mesh = test::joined(mesh, test::moved(small, {2, 0, static_cast<double>(i)}));
  }
  const Arrangement arrangement =
      test::arranged_open(mesh, std::vector<Index>(mesh.faces.size(), 0));
  ComponentWinding winding(arrangement);
  CHECK(winding.median(0, all_pieces(arrangement)) == doctest::Approx(-.5).epsilon(.02));
  CHECK(winding.on_itself(0) == doctest::Approx(.5).epsilon(.02));
}

TEST_CASE("a body that is inside out has a number near -1/2 on itself") {
  Mesh ball = test::reversed(test::icosphere(3));
  ball.faces.pop_back();
  const Arrangement arrangement =
      test::arranged_open(ball, std::vector<Index>(ball.faces.size(), 0));
  ComponentWinding winding(arrangement);
  CHECK(winding.on_itself(0) == doctest::Approx(-.5).epsilon(.02));
  CHECK(!winding.is_body(0));
}

TEST_CASE("areas are those of the mesh") {
  const Arrangement arrangement = test::arranged_open(test::grid(4), std::vector<Index>(32, 0));
  ComponentWinding winding(arrangement);
  CHECK(winding.area_of(0) == doctest::Approx(1));
  CHECK(winding.area_of(std::vector<Index>{0, 1}) == doctest::Approx(1. / 16));
}

TEST_CASE("the median at pieces of another component is the solid angle there") {
  // A small open box in the middle of a large one: the open side covers a sixth of all directions.
  const Mesh small = open_box(Vec3::Constant(-.01), Vec3::Constant(.01));
  const Mesh large = open_box(Vec3::Constant(-1), Vec3::Constant(1));
  std::vector<Index> components(large.faces.size() + small.faces.size(), 0);
  std::fill(components.begin() + std::ssize(large.faces), components.end(), 1);
  const Arrangement arrangement = test::arranged_open(test::joined(large, small), components);
  ComponentWinding winding(arrangement);
  std::vector<Index> pieces;
  for (const Index p : all_pieces(arrangement))
    if (test::corners_of(arrangement, arrangement.pieces[p])[0].norm() < .1) pieces.push_back(p);
  REQUIRE(pieces.size() == small.faces.size());
  CHECK(winding.median(0, pieces) == doctest::Approx(5. / 6).epsilon(.02));
}
