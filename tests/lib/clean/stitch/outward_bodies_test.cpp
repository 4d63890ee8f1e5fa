/// Nested shells of known orientation.
#include "clean/stitch/outward_bodies.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

Mesh ball(double radius) { return test::scaled(test::icosphere(1), radius); }

/// A ball with a cavity that contains a smaller ball.
Mesh nested() { return test::joined(test::joined(ball(3), test::reversed(ball(2))), ball(1)); }

double volume_of(const Mesh& mesh) { return test::signed_volume(mesh); }

}  // namespace

TEST_CASE("bodies oriented outwards, with cavities, stay unchanged") {
  Mesh mesh = test::joined(nested(), test::moved(ball(1), {5, 0, 0}));
  const std::vector<Face> faces = mesh.faces;
  CHECK_FALSE(has_inward_bodies(mesh));
  CHECK(turn_bodies_outwards(mesh) == 0);
  CHECK(turn_nested_alternately(mesh) == 0);
  CHECK(mesh.faces == faces);
}

TEST_CASE("an inside-out body is reversed together with its contents, and no other") {
  const Mesh other = test::moved(nested(), {9, 0, 0});
  Mesh mesh = test::joined(test::reversed(nested()), other);
  CHECK(has_inward_bodies(mesh));
  CHECK(turn_bodies_outwards(mesh) == nested().faces.size());
  CHECK(volume_of(mesh) == doctest::Approx(2 * volume_of(nested())));
  CHECK_FALSE(has_inward_bodies(mesh));
}

TEST_CASE("a cavity whose vertices are in line with edges of the body stays a cavity") {
  ShapeOptions options = test::shape("box", 0, {"4", "4", "4"});
  options.edge = 2;
  Mesh mesh = make_shape(options);
  options.parameters = {"2", "2", "2"};
  mesh = test::joined(mesh, test::reversed(make_shape(options)));
  CHECK_FALSE(has_inward_bodies(mesh));
  CHECK(turn_bodies_outwards(mesh) == 0);
}

TEST_CASE("a cavity that touches the body at each of its vertices stays a cavity") {
  ShapeOptions options = test::shape("box", 0, {"2", "2", "2"});
  options.edge = 1;
  Mesh octahedron;
  octahedron.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const Mesh body = test::joined(make_shape(options), test::reversed(octahedron));
  CHECK_FALSE(has_inward_bodies(body));
  Mesh mesh = test::reversed(body);
  CHECK(turn_bodies_outwards(mesh) == body.faces.size());
  CHECK(volume_of(mesh) == doctest::Approx(8 - 4.0 / 3));
}

TEST_CASE("copies of a body that is inside out are both reversed, in any position") {
  for (int i = 0; i < 10; ++i) {
    const Eigen::AngleAxisd turn(0.3 + i, Vec3(1, 2, 3).normalized());
    Mesh copy = test::reversed(test::cube());
    for (Vec3& p : copy.positions) p = turn * p;
    Mesh mesh = test::joined(copy, copy);
    CHECK(turn_bodies_outwards(mesh) == mesh.faces.size());
    CHECK(volume_of(mesh) == doctest::Approx(2));
  }
}

TEST_CASE("a body in a body, and a cavity in a cavity, are found") {
  CHECK_FALSE(has_bodies_in_bodies(nested()));
  CHECK(has_bodies_in_bodies(test::joined(ball(3), ball(2))));
  const Mesh cavity = test::joined(ball(3), test::reversed(ball(2)));
  CHECK_FALSE(has_bodies_in_bodies(cavity));
  CHECK(has_bodies_in_bodies(test::joined(cavity, test::reversed(ball(1)))));
}

TEST_CASE("a cavity of a body with a hole stays a cavity") {
  Mesh mesh = test::joined(ball(3), test::reversed(ball(1)));
  mesh.faces.erase(mesh.faces.begin());
  CHECK_FALSE(has_inward_bodies(mesh));
  CHECK(turn_bodies_outwards(mesh) == 0);
}

TEST_CASE("nested components are oriented outwards and inwards alternately") {
  for (int directions = 0; directions < 8; ++directions) {
    Mesh mesh;
    for (int i = 0; i < 3; ++i) {
      const Mesh shell = ball(3 - i);
      mesh = test::joined(mesh, (directions >> i & 1) != 0 ? test::reversed(shell) : shell);
    }
    turn_nested_alternately(mesh);
    CHECK(volume_of(mesh) == doctest::Approx(volume_of(nested())));
  }
}

TEST_CASE("with outwards, a shuffled cavity takes the orientation of most faces") {
  Mesh mesh = nested();
  for (std::size_t f = 0; f < mesh.faces.size(); f += 3)
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
  Mesh alone = mesh;
  stitch(mesh, {.orient = true, .outwards = true});
  CHECK(volume_of(mesh) == doctest::Approx(volume_of(nested())));
  // Without `outwards`, every component with inconsistent faces is oriented outwards.
  stitch(alone, {.orient = true});
  CHECK(volume_of(alone) ==
        doctest::Approx(volume_of(ball(3)) + volume_of(ball(2)) + volume_of(ball(1))));
}
