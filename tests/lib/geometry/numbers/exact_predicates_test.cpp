// Signs of predicates, compared with rationals.
#include <doctest/doctest.h>

#include "helpers/defined_points.h"

using namespace transformesh;

using test::Plane;
using test::Rational;
using test::RationalPoint;
using test::Scene;
using test::sign;

TEST_CASE("orientation and order of defined points agree with rationals") {
  test::Random random(7);
  int defined = 0;
  int equal = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Scene scene = test::random_scene(seed, seed % 3 == 0 ? 1e7 : 0.1);
    // Scales the coordinates so that their products leave the range of doubles.
    if (seed > 60)
      for (Vec3& p : scene.positions) p = Vec3(1e-140, 1e130, 1e145).cwiseProduct(p);
    test::add_points(scene);
    const ExactGeometry geometry(scene.positions, scene.faces);
    std::vector<ExactPlane> planes;
    for (Index f = 0; f < 6; ++f) planes.push_back(geometry.plane(f));
    defined += static_cast<int>(scene.points.size() - scene.positions.size());
    const auto pick = [&] {
      return static_cast<std::size_t>(random.uniform(0, static_cast<double>(scene.points.size())));
    };
    for (int i = 0; i < 200; ++i) {
      const std::size_t a = pick(), b = pick(), c = pick();
      const RationalPoint &p = scene.truth[a], &q = scene.truth[b], &r = scene.truth[c];
      const int turn = sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
      REQUIRE(geometry.orient2d(scene.points[a], scene.points[b], scene.points[c], {0, 1}) == turn);
      const int order = p < q ? -1 : (q < p ? 1 : 0);
      equal += order == 0 && a != b ? 1 : 0;
      REQUIRE(geometry.compare(scene.points[a], scene.points[b]) == order);
      const Face& f = scene.faces[c % 6];
      const Plane plane = test::plane_of(scene.positions, f);
      const Triangle t{scene.positions[f[0]], scene.positions[f[1]], scene.positions[f[2]]};
      const int side = sign(test::dot(plane.normal, p) - plane.offset);
      REQUIRE(geometry.orient3d(t, scene.points[a]) == side);
      REQUIRE(geometry.orient3d(planes[c % 6], scene.points[a]) == side);
      for (int k = 0; k < 3; ++k) {
        const Rational off = p[static_cast<std::size_t>(k)] - Rational(scene.points[a].center[k]);
        REQUIRE(abs(off) <= Rational(scene.points[a].radius[k]));
      }
    }
  }
  CHECK(defined > 300);
  CHECK(equal > 20);
}

TEST_CASE("the Delaunay diagonal of coplanar points agrees with rationals") {
  test::Random random(11);
  int cocircular = 0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<Vec3> positions;
    for (int i = 0; i < 4; ++i) {
      const double x = static_cast<double>(random.below(5)),
                   y = static_cast<double>(random.below(5));
      positions.push_back(x * Vec3(2, 1, -2) + y * Vec3(1, 2, 2));
    }
    const ExactGeometry geometry(positions, {});
    const ExactPoint a = geometry.given(0), b = geometry.given(1), c = geometry.given(2),
                     d = geometry.given(3);
    const PlaneProjection xy{0, 1};
    if (geometry.orient2d(a, b, c, xy) <= 0 || geometry.orient2d(b, a, d, xy) <= 0) continue;
    // The edge ab is Delaunay if the angles at c and d have a sum below pi.
    std::array<RationalPoint, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = test::exact(positions[i]);
    const auto ca = test::minus(p[0], p[2]), cb = test::minus(p[1], p[2]);
    const auto da = test::minus(p[0], p[3]), db = test::minus(p[1], p[3]);
    const RationalPoint up = test::cross(ca, cb), down = test::cross(db, da);
    const RationalPoint normal{Rational(2), Rational(-2), Rational(1)};
    const int expected = sign(test::dot(ca, cb) * test::dot(down, normal) +
                              test::dot(da, db) * test::dot(up, normal));
    cocircular += expected == 0 ? 1 : 0;
    REQUIRE(geometry.delaunay_sign(a, b, c, d, xy) == expected);
  }
  CHECK(cocircular > 10);
}
