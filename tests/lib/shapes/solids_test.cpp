#include "shapes/solids.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/mesh_facts.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("the vertices of an ellipsoid lie on it") {
  const Vec3 axes(1, 0.8, 0.5);
  for (const Vec3& point : shapes::ellipsoid(axes, 2000, {}).positions)
    CHECK(point.cwiseQuotient(axes).norm() == doctest::Approx(1).epsilon(1e-11));
}

TEST_CASE("a plate lies in its plane with its holes around the middle, 2.4 wide") {
  for (const long holes : {1, 3, 5}) {
    CAPTURE(holes);
    const Mesh mesh = shapes::genus(holes, 6000, {});
    CHECK(count(mesh).genera == std::vector<long>{holes});
    double widest = 0;
    double thickest = 0;
    for (const Vec3& point : mesh.positions) {
      widest = std::max(widest, point.head<2>().norm());
      thickest = std::max(thickest, std::abs(point.z()));
    }
    CHECK(widest == doctest::Approx(1.2).epsilon(0.01));
    CHECK(thickest < 0.5);
  }
  // A single hole leaves a round plate, whose middle is free.
  CHECK(winding_number(shapes::genus(1, 6000, {}), {0, 0, 0}) == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("the balls of a dumbbell have their radius, its neck is there or turned inside out") {
  const auto widest_at = [](const Mesh& mesh, double z) {
    double widest = 0;
    for (const Vec3& p : mesh.positions)
      if (std::abs(p.z() - z) < 0.02) widest = std::max(widest, p.head<2>().norm());
    return widest;
  };
  const Mesh plain = shapes::dumbbell(0.15, 6000, {});
  CHECK(widest_at(plain, 0.7) == doctest::Approx(0.5).epsilon(0.002));
  CHECK(widest_at(plain, -0.7) == doctest::Approx(0.5).epsilon(0.002));
  CHECK(widest_at(plain, 0) == doctest::Approx(0.15).epsilon(0.02));
  CHECK(winding_number(plain, {0, 0, 0}) == doctest::Approx(1));
  // The balls are those of the plain shape.
  const Mesh inverted = shapes::dumbbell(-0.15, 6000, {});
  CHECK(inverted.faces == plain.faces);
  CHECK(winding_number(inverted, {0, 0, 0}) == doctest::Approx(-1));
  CHECK(winding_number(inverted, {0, 0, 0.7}) == doctest::Approx(1));
}

TEST_CASE("a bowl is a shell of half thickness 0.27 about a sphere of radius 0.9, open upwards") {
  const Mesh mesh = shapes::bowl(6000, {});
  for (const Vec3& point : mesh.positions) {
    if (point.z() > 0) continue;
    CHECK(std::abs(point.norm() - 0.9) == doctest::Approx(0.27).epsilon(1e-9));
  }
  CHECK(winding_number(mesh, {0, 0, -0.9}) == doctest::Approx(1));
  CHECK(winding_number(mesh, {0, 0, 0.9}) == doctest::Approx(0));
  CHECK(winding_number(mesh, {0, 0, 0}) == doctest::Approx(0));
}
