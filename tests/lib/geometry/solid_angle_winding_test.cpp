#include "geometry/solid_angle_winding.h"

#include <doctest/doctest.h>

#include <random>

#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

BoundedWindingNumber at(const Mesh& mesh, const Vec3& point) {
  return SolidAngleWinding(mesh)(point);
}

bool has_number(const Mesh& mesh, const Vec3& point, int number) {
  const BoundedWindingNumber winding = at(mesh, point);
  return winding.is_decided() && winding.rounded() == number;
}

/// Returns the sum of arctangents in the form of the reference.
double sum_of_solid_angles(const Mesh& mesh, const Vec3& point) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    const Vec3 a = mesh.positions[face[0]] - point;
    const Vec3 b = mesh.positions[face[1]] - point;
    const Vec3 c = mesh.positions[face[2]] - point;
    const double above = a.dot(b.cross(c));
    const double below = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                         b.dot(c) * a.norm() + c.dot(a) * b.norm();
    sum += 2 * std::atan2(above, below);
  }
  return sum / (4 * std::numbers::pi);
}

std::vector<Vec3> random_points(std::size_t count, double half_width) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-half_width, half_width);
  std::vector<Vec3> points(count);
  for (Vec3& point : points) point = {coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

}  // namespace

TEST_CASE("the winding number counts enclosing surfaces with their sign") {
  const Mesh outer = cuboid({-2, -2, -2}, {2, 2, 2});
  const Mesh inner = cuboid({-1, -1, -1}, {1, 1, 1});
  const Vec3 inside(0.1, 0.2, 0.3);
  const Vec3 between(1.5, 0.2, 0.3);
  const Vec3 outside(3, 0.2, 0.3);

  CHECK(has_number(outer, inside, 1));
  CHECK(has_number(outer, outside, 0));
  CHECK(has_number(reversed(outer), inside, -1));
  CHECK(has_number(joined(outer, inner), inside, 2));
  CHECK(has_number(joined(outer, inner), between, 1));
  CHECK(has_number(joined(outer, reversed(inner)), inside, 0));
  Mesh many = outer;
  for (int i = 0; i < 6; ++i) many = joined(many, outer);
  CHECK(has_number(many, inside, 7));
  CHECK(has_number(reversed(many), inside, -7));
  CHECK(has_number(Mesh{}, inside, 0));
}

TEST_CASE("the winding number is the sum of the solid angles, also of an open mesh") {
  const Mesh ring = torus(2, 0.7, 40, 20);
  Mesh open = ring;
  open.faces.resize(open.faces.size() / 3);
  for (const Vec3& point : random_points(200, 3)) {
    const BoundedWindingNumber closed_winding = at(ring, point);
    REQUIRE(closed_winding.is_decided());
    CHECK(std::abs(closed_winding.number - sum_of_solid_angles(ring, point)) < 1e-11);

    const double outward = std::hypot(point.x(), point.y()) - 2;
    const double distance = std::hypot(outward, point.z());
    if (std::abs(distance - 0.7) > 0.05)
      CHECK(closed_winding.rounded() == (distance < 0.7 ? 1 : 0));

    const BoundedWindingNumber open_winding = at(open, point);
    CHECK(std::abs(open_winding.number - sum_of_solid_angles(open, point)) < 1e-11);
    CHECK_FALSE(open_winding.is_decided());
  }
}

TEST_CASE("the winding number is undecided on the surface and decided a hair beside it") {
  const Mesh box = cube();
  for (const Vec3& point : {Vec3(0.25, 0.5, 0), Vec3(0.5, 0.5, 1), Vec3(0, 0, 0.5), Vec3(1, 1, 1)})
    CHECK_FALSE(at(box, point).is_decided());
  CHECK(has_number(box, {0.3, 0.4, 1e-12}, 1));
  CHECK(has_number(box, {0.3, 0.4, -1e-12}, 0));
  CHECK(has_number(box, {1e-10, 1e-10, 1e-10}, 1));
  CHECK(has_number(box, {-1e-10, 1e-10, 1e-10}, 0));
  // On the line of an edge, beyond its end.
  CHECK(has_number(box, {0, 0, 2}, 0));
}

TEST_CASE("the winding number holds for any size, place and for degenerate faces") {
  for (const double size : {1e-150, 1e-30, 1e30, 1e150, 1e300}) {
    const Mesh ball = scaled(icosphere(2), size);
    CHECK(has_number(ball, Vec3(0.3, 0.2, 0.1) * size, 1));
    CHECK(has_number(ball, Vec3(3, 2, 1) * size, 0));
    CHECK(has_number(ball, Vec3(1e300, 1e300, 0), 0));
  }
  const Vec3 away(1e6, -1e6, 1e6);
  CHECK(has_number(moved(icosphere(2), away), away + Vec3(0.3, 0.2, 0.1), 1));

  Mesh pinched = cube();
  pinched.faces.push_back({0, 0, 7});
  pinched.faces.push_back({3, 3, 3});
  CHECK(has_number(pinched, {0.3, 0.4, 0.1}, 1));
  pinched.positions.push_back({0.3, 0.4, 0.1});  // not used by a face
  CHECK(has_number(pinched, {0.3, 0.4, 0.1}, 1));
}

TEST_CASE("the error bound of the winding number holds in small faces far away and near by") {
  const Mesh ball = icosphere(5);
  for (const Vec3& direction : random_points(50, 1)) {
    const Vec3 unit = direction.normalized();
    for (const double radius : {0.01, 0.9, 0.99, 1.001, 1.01, 10.0, 1e6}) {
      const BoundedWindingNumber winding = at(ball, unit * radius);
      REQUIRE(winding.is_decided());
      CHECK(winding.error < 1e-6);
      CHECK(winding.rounded() == (radius < 1 ? 1 : 0));
    }
  }
}

TEST_CASE("many winding numbers are those of each point, for any number of threads") {
  const Mesh ball = joined(icosphere(3), moved(icosphere(3), {0.5, 0, 0}));
  const SolidAngleWinding query(ball);
  const std::vector<Vec3> points = random_points(300, 1.5);
  const std::vector<BoundedWindingNumber> windings = query(points);
  const ThreadLimit one(1);
  const std::vector<BoundedWindingNumber> again = query(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(windings[i].number == query(points[i]).number);
    CHECK(windings[i].number == again[i].number);
    CHECK(windings[i].error == again[i].error);
  }
}
