#include "mesh/triangle.h"

#include <doctest/doctest.h>

#include <numbers>

#include "helpers/shapes.h"

using namespace transformesh;

TEST_CASE("a face's triangle has its corners in order, and a normal of twice its area") {
  const Mesh mesh = test::tetrahedron();
  const Triangle triangle = triangle_of(mesh, 3);
  CHECK(triangle == Triangle{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)});
  CHECK(normal_of(triangle[0], triangle[1], triangle[2]) == Vec3(1, 1, 1));
}

TEST_CASE("cotangents are those of the angles, which count as 5 to 175 degrees") {
  const auto at = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return clamped_cotangent(Vec3(2, 0, 0), 3 * Vec3(std::cos(angle), std::sin(angle), 0));
  };
  CHECK(at(45) == doctest::Approx(1));
  CHECK(at(60) == doctest::Approx(1 / std::sqrt(3)));
  CHECK(at(120) == doctest::Approx(-1 / std::sqrt(3)));
  CHECK(at(5.01) == doctest::Approx(1 / std::tan(5.01 * std::numbers::pi / 180)));
  CHECK(at(1) == doctest::Approx(1 / std::tan(5 * std::numbers::pi / 180)));
  CHECK(at(0) == at(1));
  CHECK(at(180) == -at(0));
}
