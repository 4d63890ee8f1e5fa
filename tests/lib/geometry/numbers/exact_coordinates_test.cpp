#include "geometry/numbers/exact_coordinates.h"

#include <doctest/doctest.h>

#include "helpers/defined_points.h"

using namespace transformesh;

TEST_CASE("positions are the rational positions, rounded to within a unit in the last place") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    test::Scene scene = test::random_scene(seed, 0.1);
    // Magnitudes so far apart that balls of homogeneous coordinates are used.
    if (seed > 15)
      for (Vec3& p : scene.positions) p = Vec3(1e-140, 1, 1e100).cwiseProduct(p);
    test::add_points(scene);
    const ExactGeometry geometry(scene.positions, scene.faces);
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      const Vec3 position = geometry.position(scene.points[i]);
      for (int k = 0; k < 3; ++k) {
        const test::Rational& truth = scene.truth[i][static_cast<std::size_t>(k)];
        REQUIRE(abs(test::Rational(position[k]) - truth) <= abs(truth) / (1LL << 52));
      }
    }
  }
}

TEST_CASE("a point with an exact position needs no definition") {
  CHECK(is_exact(ExactGeometry::free({1, 2, 3})));
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 3}, {3, 1, -7}};
  const std::vector<Face> faces{{0, 1, 2}};
  const ExactGeometry geometry(positions, faces);
  CHECK(!is_exact(geometry.point(PointDefinition::line_plane(3, 4, 0))));
}
