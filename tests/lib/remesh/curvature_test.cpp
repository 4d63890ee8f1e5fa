#include "remesh/curvature.h"

#include <algorithm>
#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "remesh/halfedges/vertex_role.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// The extreme values of curvature times `radius` over the vertices.
struct Extremes {
  double least = 1e300;
  double largest = 0;

  Extremes(const Mesh& mesh, double radius) {
    for (const double curvature : largest_curvatures(EditableMesh(mesh))) {
      least = std::min(least, radius * curvature);
      largest = std::max(largest, radius * curvature);
    }
  }
};

}  // namespace

TEST_CASE("a sphere has the curvature of its radius") {
  const Extremes regular(scaled(icosphere(4), 3), 3);
  CHECK(regular.least == doctest::Approx(1).epsilon(0.03));
  CHECK(regular.largest == doctest::Approx(1).epsilon(0.03));

  // the result does not depend on the triangles
  Mesh irregular = icosphere(4);
  Random random(1);
  for (Vec3& point : irregular.positions) point = (point + random.point(-0.02, 0.02)).normalized();
  const Extremes extremes(irregular, 1);
  CHECK(extremes.least > 0.9);
  CHECK(extremes.largest < 1.25);
}

TEST_CASE("inwards or outwards is the same curvature") {
  const Extremes inwards(reversed(icosphere(3)), 1);
  CHECK(inwards.least == doctest::Approx(1).epsilon(0.05));
}

TEST_CASE("the largest curvature of a torus is that of its tube") {
  // The largest curvature is 1 / minor, because the large circle bends less everywhere.
  const Extremes tube(torus(1, 0.25, 160, 48), 0.25);
  CHECK(tube.least == doctest::Approx(1).epsilon(0.03));
  CHECK(tube.largest == doctest::Approx(1).epsilon(0.03));
}

TEST_CASE("the curvature of an ellipsoid agrees with the closed form") {
  // On x^2 + y^2 + z^2 / 4 = 1, let s be cos^2 + 4 sin^2 of the parameter's angle from the pole.
  // The normal curvature is 2 / s^(3/2) along a meridian, and 2 / sqrt(s) along a parallel.
  Mesh mesh = icosphere(5);
  for (Vec3& point : mesh.positions) point.z() *= 2;
  const std::vector<double> curvatures = largest_curvatures(EditableMesh(mesh));
  double worst = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double cosine = mesh.positions[v].z() / 2;
    const double stretch = cosine * cosine + 4 * (1 - cosine * cosine);
    const double meridian = 2 / std::pow(stretch, 1.5);
    const double parallel = 2 / std::sqrt(stretch);
    worst = std::max(worst, std::abs(curvatures[v] / std::max(meridian, parallel) - 1));
  }
  CHECK(worst < 0.06);
}

TEST_CASE("flat parts and feature edges have no curvature") {
  const Extremes flat(grid(10), 1);
  CHECK(flat.largest == doctest::Approx(0));

  EditableMesh box(cube());
  mark_features(box, 45);
  for (const double curvature : largest_curvatures(box)) CHECK(curvature == doctest::Approx(0));
  for (const double curvature : largest_curvatures(EditableMesh(cube()))) CHECK(curvature > 0.5);
}
