/// Triangles over waves, checked by dense samples against all faces (sampled_distance.h).
#include "remesh/guards/projected_faces.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/random.h"
#include "helpers/sampled_distance.h"
#include "helpers/shapes.h"
#include "lib/remesh/double_cone.h"
#include "remesh/halfedges/halfedges.h"

using namespace transformesh;

namespace {

Mesh waves(double height) {
  Mesh mesh = test::grid(16);
  for (Vec3& p : mesh.positions) p.z() = height * std::sin(9 * p.x()) * std::cos(7 * p.y());
  return mesh;
}

bool covers(const Mesh& mesh, const Triangle& triangle, double distance, std::size_t most = 1000,
            bool stops_at_corners = false) {
  ProjectedFaces faces(mesh, manifold_opposites(mesh), stops_at_corners);
  const Vec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3;
  Index seed = 0;
  double least = HUGE_VAL;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const double squared = test::squared_to_triangle(middle, triangle_of(mesh, f));
    if (squared < least) seed = f, least = squared;
  }
  return faces.covers(triangle, seed, distance * distance, most);
}

Mesh alone(const Triangle& triangle) {
  Mesh mesh;
  mesh.positions.assign(triangle.begin(), triangle.end());
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

}  // namespace

TEST_CASE("the distance of a triangle over a plane is its largest height") {
  const Mesh plane = test::grid(10);
  const Triangle above{Vec3(0.13, 0.21, 0.1), Vec3(0.81, 0.32, 0.1), Vec3(0.4, 0.77, 0.1)};
  CHECK(covers(plane, above, 0.1 + 1e-12));
  CHECK_FALSE(covers(plane, above, 0.1 - 1e-12));
  CHECK_FALSE(covers(plane, above, 0.2, 10));  // too many faces
  const Triangle backwards{above[0], above[2], above[1]};
  CHECK(covers(plane, backwards, 0.1 + 1e-12));
}

TEST_CASE("a triangle that goes beyond a border, or over a hole, is not certified") {
  Mesh plane = test::grid(10);
  const Triangle beyond{Vec3(0.1, 0.2, 0), Vec3(1.01, 0.3, 0), Vec3(0.4, 0.7, 0)};
  CHECK_FALSE(covers(plane, beyond, 0.5));
  const Triangle inside{Vec3(0.1, 0.2, 0), Vec3(0.91, 0.3, 0), Vec3(0.4, 0.7, 0)};
  CHECK(covers(plane, inside, 1e-12));
  plane.faces.erase(plane.faces.begin() + 88);  // a face of a square in the middle
  CHECK_FALSE(covers(plane, inside, 0.5));
}

TEST_CASE("the other faces at a corner of high valence are not needed") {
  const Mesh cone = test::double_cone(400);
  const Vec3 &apex = cone.positions[400], &first = cone.positions[0];
  const Triangle chord{apex, first, cone.positions[6]};
  const double height = (chord[1] + chord[2]).norm() / 2;  // distance of the chord from the axis
  // The circle is 1 - height away from the chord, and the cone's sides have an angle of 45 degrees.
  const double distance = (1 - height) / std::sqrt(2.0);
  CHECK(covers(cone, chord, 1.01 * distance, 20, true));
  CHECK(covers(cone, {first, chord[2], apex}, 1.01 * distance, 20, true));
  CHECK_FALSE(covers(cone, chord, 1.01 * distance, 20));
  CHECK_FALSE(covers(cone, chord, 0.99 * distance, 20, true));
  CHECK_FALSE(covers(cone, {apex, first, cone.positions[80]}, 1, 20, true));  // 80 faces over it
}

TEST_CASE("triangles without area, or as thin as needles, are not certified") {
  const Mesh plane = test::grid(10);
  CHECK_FALSE(covers(plane, {Vec3(0.1, 0.1, 0), Vec3(0.5, 0.5, 0), Vec3(0.9, 0.9, 0)}, 0.5));
  CHECK_FALSE(covers(plane, {Vec3(0.1, 0.1, 0), Vec3(0.5, 0.5, 0), Vec3(0.9, 0.9, 1e-9)}, 0.5));
}

TEST_CASE("samples of random triangles are within the distance that is certified") {
  const Mesh mesh = waves(0.05);
  test::Random random(1);
  int certified = 0;
  for (int i = 0; i < 400; ++i) {
    Triangle triangle;
    for (Vec3& p : triangle) {
      p = random.point(0.05, 0.95);
      p.z() = random.uniform(-0.03, 0.03);
    }
    const double distance = random.uniform(0.02, 0.12);
    if (!covers(mesh, triangle, distance)) continue;
    ++certified;
    CHECK(test::sampled_distance(alone(triangle), mesh, 24) <= distance);
  }
  CHECK(certified > 100);
  CHECK(certified < 300);
}
