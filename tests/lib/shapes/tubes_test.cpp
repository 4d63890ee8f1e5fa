#include "shapes/tubes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers/mesh_facts.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("a torus lies on the torus, all valences are six, and triangles are nearly equilateral") {
  const Mesh mesh = shapes::torus(1, 0.4, 4000);
  for (const Vec3& p : mesh.positions)
    CHECK(std::hypot(p.head<2>().norm() - 1, p.z()) == doctest::Approx(0.4).epsilon(1e-13));
  for (const std::size_t valence : Halfedges(mesh).valence) CHECK(valence == 6);
  CHECK(mean_smallest_angle(mesh) > 57);
  CHECK(count(mesh).genera == std::vector<long>{1});
  CHECK(static_cast<double>(mesh.faces.size()) == doctest::Approx(4000).epsilon(0.03));
}

TEST_CASE("a phase moves the grid along the torus, a whole step onto itself") {
  const Mesh mesh = shapes::torus(1, 0.4, 1000);
  const Mesh half = shapes::torus(1, 0.4, 1000, 0.5);
  CHECK(half.faces == mesh.faces);
  CHECK(half.positions != mesh.positions);
  CHECK(signed_volume(half) == doctest::Approx(signed_volume(mesh)).epsilon(0.01));
}

TEST_CASE("linked tori are as far apart as asked for") {
  // Each tube consists of the points within 0.27 of its center circle. The circles come closest, at
  // distance 0.62, on the line through both centers.
  const Mesh mesh = shapes::tori(0.08, 20000);
  const std::size_t half = mesh.positions.size() / 2;
  double least = 1e9;
  for (std::size_t i = 0; i < half; i += 3)
    for (std::size_t k = half; k < mesh.positions.size(); k += 3)
      least = std::min(least, (mesh.positions[i] - mesh.positions[k]).norm());
  CHECK(least > 0.08 - 1e-12);
  CHECK(least < 0.1);
  CHECK(count(mesh).genera == std::vector<long>{1, 1});
}

TEST_CASE("a knot's tube is round: all vertices are its radius from the curve") {
  const Mesh mesh = shapes::torus_knot(2, 3, 1, 0.1, 6000);
  std::vector<Vec3> curve;
  constexpr int samples = 20000;
  for (int i = 0; i < samples; ++i) {
    const double t = 2 * std::numbers::pi * i / samples;
    const double radius = 1 + 0.42 * std::cos(3 * t);
    curve.emplace_back(radius * std::cos(2 * t), radius * std::sin(2 * t), 0.42 * std::sin(3 * t));
  }
  for (std::size_t v = 0; v < mesh.positions.size(); v += 17) {
    double least = 1e9;
    for (const Vec3& point : curve) least = std::min(least, (point - mesh.positions[v]).norm());
    CHECK(least == doctest::Approx(0.1).epsilon(1e-4));
  }
}

TEST_CASE(
    "the thickness of a knot goes with its size, and a tube of it does not intersect itself") {
  const double thickness = shapes::torus_knot_thickness(2, 3, 1);
  CHECK(shapes::torus_knot_thickness(2, 3, 2) == doctest::Approx(2 * thickness).epsilon(1e-12));
  CHECK(crossings(shapes::torus_knot(2, 3, 1, 0.95 * thickness, 1500)).pairs == 0);
  CHECK(crossings(shapes::torus_knot(2, 3, 1, 1.3 * thickness, 1500)).pairs > 0);
  // The thickness of a curve that winds once and does not intersect itself is limited by its own
  // curvature alone.
  CHECK(shapes::torus_knot_thickness(1, 1, 1) > thickness);
}
