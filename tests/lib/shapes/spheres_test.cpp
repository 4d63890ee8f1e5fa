#include "shapes/spheres.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/mesh_facts.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("a geodesic sphere has 20 n^2 faces, twelve vertices of valence five and others of six") {
  for (const std::size_t n : {1, 2, 3, 7, 12}) {
    CAPTURE(n);
    const Mesh mesh = shapes::geodesic_sphere(n);
    CHECK(mesh.faces.size() == 20 * n * n);
    CHECK(mesh.positions.size() == 10 * n * n + 2);
    for (const Vec3& point : mesh.positions)
      CHECK(point.norm() == doctest::Approx(1).epsilon(1e-15));
    CHECK(count(mesh).genera == std::vector<long>{0});
    std::size_t fives = 0;
    for (const std::size_t valence : Halfedges(mesh).valence) {
      CHECK((valence == 5 || valence == 6));
      fives += valence == 5;
    }
    CHECK(fives == 12);
  }
}

TEST_CASE("the frequency is the one whose number of faces is closest") {
  CHECK(shapes::geodesic_frequency(0) == 1);
  CHECK(shapes::geodesic_frequency(20) == 1);
  CHECK(shapes::geodesic_frequency(49) == 1);  // 20 and 80 differ by 29 and 31 from 49
  CHECK(shapes::geodesic_frequency(51) == 2);
  CHECK(shapes::geodesic_frequency(20 * 37 * 37) == 37);
}

TEST_CASE("the inner radius is that of the icosahedron, and approaches one") {
  // Ratio of the inscribed and the circumscribed radius of the icosahedron.
  const double phi = std::numbers::phi;
  const double inner = phi * phi / (2 * std::sqrt(3)) / (std::sqrt(phi * phi + 1) / 2);
  CHECK(shapes::geodesic_inner_radius(1) == doctest::Approx(inner).epsilon(1e-14));
  CHECK(shapes::geodesic_inner_radius(20) > 0.998);
  CHECK(shapes::geodesic_inner_radius(20) < 1);
}

TEST_CASE("two spheres keep their gap") {
  const Mesh mesh = shapes::two_spheres(0.5, 0.2, 2000);
  double left = -1e9;
  double right = 1e9;
  for (const Vec3& point : mesh.positions) {
    const Vec3 center(point.x() < 0 ? -0.6 : 0.6, 0, 0);
    CHECK((point - center).norm() == doctest::Approx(0.5).epsilon(1e-14));
    (point.x() < 0 ? left : right) =
        point.x() < 0 ? std::max(left, point.x()) : std::min(right, point.x());
  }
  CHECK(left < -0.1);
  CHECK(left > -0.11);
  CHECK(right > 0.1);
  CHECK(right < 0.11);
}

TEST_CASE("many spheres lie in the ball of radius 1.2 and share out the faces") {
  const Mesh mesh = shapes::many_spheres(30, 5, 20000);
  CHECK(static_cast<double>(mesh.faces.size()) == doctest::Approx(20000).epsilon(0.02));
  for (const Vec3& point : mesh.positions) CHECK(point.norm() < 1.2 + 1e-12);
  CHECK(count(mesh).genera == std::vector<long>(30, 0));
}
