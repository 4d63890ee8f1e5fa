#include "geometry/plane_distances.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "geometry/numbers/exact_number.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

int exact_side(const CutPlane& plane, const Vec3& p) {
  const auto product = [&](int i) { return ExactNumber(plane.normal[i]) * ExactNumber(p[i]); };
  return sign_of(product(0) + product(1) + product(2) - ExactNumber(plane.offset));
}

int sign(double number) { return static_cast<int>(number > 0) - static_cast<int>(number < 0); }

}  // namespace

TEST_CASE("vertices in a plane have distance 0, whatever the length of its normal") {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> digit(-9, 9);
  const auto number = [&] { return static_cast<double>(digit(random)); };
  for (int i = 0; i < 1000; ++i) {
    Mesh mesh;
    mesh.positions = {{number(), number(), number()}};
    const Vec3 normal(number(), number(), number());
    if (normal.isZero()) continue;
    const PlaneDistances distances(mesh, {normal, normal.dot(mesh.positions[0])});
    CHECK(distances[0] == 0);
  }
}

TEST_CASE("the sign of a distance is exact next to the plane") {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 normal(number(random), number(random), number(random));
    const Vec3 point(number(random), number(random), number(random));
    Mesh mesh;
    mesh.positions.assign(1, point);
    double offset = std::nextafter(normal.dot(point), -9);
    for (int step = 0; step < 3; ++step, offset = std::nextafter(offset, 9)) {
      const CutPlane plane{normal, offset};
      CHECK(sign(PlaneDistances(mesh, plane)[0]) == exact_side(plane, point));
    }
  }
}

TEST_CASE("the sign of a distance is exact for numbers of very different size") {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  Mesh mesh;
  mesh.positions = {{1, 1e-200, 0}, {1, -1e-200, 0}, {1, 0, 0}, {1, 1e300, -1e300}};
  const PlaneDistances distances(mesh, {{1, 1e-200, 1e-200}, 1});
  CHECK(distances[0] == least);
  CHECK(distances[1] == -least);
  CHECK(distances[2] == 0);
  CHECK(distances[3] == 0);
  const PlaneDistances far(mesh, {{0, 1e300, 1e300}, 0});
  CHECK(far[0] > 0);
  CHECK(far[1] < 0);
  CHECK(far[3] == 0);
}

TEST_CASE("an edge that ends in the plane meets it at this end") {
  Mesh mesh;
  mesh.positions = {{0.1, 0.7, 0.3}, {0.5, 0.9, 0.8}};
  const PlaneDistances low(mesh, {{0, 0, 1}, 0.3});
  CHECK(low.crossing(1, 0).position == mesh.positions[0]);
  CHECK(low.crossing(1, 0).weight == 0);
  mesh.positions[1] = {0.5, 5, 0.8};
  const PlaneDistances end(mesh, {{1, 1, 0}, 5.5});
  CHECK(end.crossing(0, 1).position == mesh.positions[1]);
  CHECK(end.crossing(0, 1).weight == 1);
}

TEST_CASE("a normal without direction is refused") {
  const Mesh mesh;
  CHECK_THROWS_AS(PlaneDistances(mesh, {{0, 0, 0}, 1}), UsageError);
}
