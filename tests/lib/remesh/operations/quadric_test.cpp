#include "remesh/operations/quadric.h"

#include <doctest/doctest.h>

#include <vector>

using namespace transformesh;

namespace {

/// The quadric of the planes with the given normals through `point`, relative to 0.
Quadric planes_through(const Vec3& point, const std::vector<Vec3>& normals) {
  Quadric sum;
  for (const Vec3& normal : normals) sum += Quadric(normal.normalized(), 1);
  return sum.relative_to(-point);
}

double distance(const Vec3& a, const Vec3& b) { return (a - b).norm(); }

}  // namespace

TEST_CASE("the least point of three planes is their common point") {
  const Vec3 corner(0.3, -0.2, 0.7);
  const Vec3 start(1, 1, 1);
  const Quadric cube = planes_through(corner, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(distance(cube.least_near(start), corner) < 1e-15);
  const Quadric skew = planes_through(corner, {{1, 0.1, 0}, {0, 1, 0.5}, {0.8, 0, 1}});
  CHECK(distance(skew.least_near(start), corner) < 1e-14);
  const Quadric flat = planes_through(corner, {{1, 0, 0}, {1, 0.2, 0}, {1, 0, 0.2}});
  CHECK(distance(flat.least_near(start), corner) < 1e-12);
}

TEST_CASE("the least point of two planes is the point of their line that is nearest to the start") {
  const Quadric edge = planes_through({0.3, -0.2, 0.7}, {{1, 0, 0}, {1, 1, 0}});
  CHECK(distance(edge.least_near({5, 6, 7}), {0.3, -0.2, 7}) < 1e-14);
}

TEST_CASE("the least point of one plane is the projection of the start") {
  const Quadric plane = planes_through({0, 0, 0.7}, {{0, 0, 1}, {0, 0, 1}});
  CHECK(distance(plane.least_near({5, 6, 7}), {5, 6, 0.7}) < 1e-14);
}

TEST_CASE("planes that are equal but for rounding errors are one plane") {
  const Quadric plane = planes_through({0, 0, 0.7}, {{0, 0, 1}, {1e-9, 0, 1}, {0, -1e-9, 1}});
  CHECK(distance(plane.least_near({5, 6, 7}), {5, 6, 0.7}) < 1e-7);
}

TEST_CASE("a quadric without planes keeps the start") {
  CHECK(Quadric().least_near({5, 6, 7}) == Vec3(5, 6, 7));
}
