#include "geometry/keep_out.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <doctest/doctest.h>

#include <cmath>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Returns the least distance between grids of points on both triangles. It exceeds the distance of
/// the triangles by at most the size of a grid cell.
double sampled_distance(const Triangle& first, const Triangle& second, int n) {
  const auto points = [n](const Triangle& t) {
    std::vector<Vec3> grid;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        grid.push_back(t[0] + double(i) / n * (t[1] - t[0]) + double(j) / n * (t[2] - t[0]));
    return grid;
  };
  double least = HUGE_VAL;
  const std::vector<Vec3> others = points(second);
  for (const Vec3& p : points(first))
    for (const Vec3& q : others) least = std::min(least, (p - q).norm());
  return least;
}

Triangle moved(Triangle triangle, const Vec3& by) {
  for (Vec3& corner : triangle) corner += by;
  return triangle;
}

/// The faces around a vertex in the middle of a hexagon.
std::vector<Triangle> star(const Vec3& center) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < 6; ++i) {
    const auto rim = [](int k) {
      return Vec3(std::cos(k * std::acos(-1) / 3), std::sin(k * std::acos(-1) / 3), 0);
    };
    triangles.push_back({center, rim(i), rim(i + 1)});
  }
  return triangles;
}

}  // namespace

TEST_CASE("the distance of triangles is that of their points, by brute force") {
  test::Random random(7);
  const auto corner = [&] { return random.point(0, 1); };
  std::size_t crossings = 0;
  for (int i = 0; i < 300; ++i) {
    const Triangle first{corner(), corner(), corner()};
    const Triangle second =
        moved({corner(), corner(), corner()}, Vec3(0, 0, i % 3 == 0 ? 0.8 : 0.1));
    const double distance = distance_of(first, second);
    const double sampled = sampled_distance(first, second, 24);
    CHECK(distance <= sampled + 1e-12);
    CHECK(sampled - distance < 0.08);
    CHECK(distance == Approx(distance_of(second, first)).epsilon(1e-9));
    using Kernel = CGAL::Simple_cartesian<double>;
    const auto cgal = [](const Triangle& t) {
      const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
      return Kernel::Triangle_3(point(t[0]), point(t[1]), point(t[2]));
    };
    const bool meets = CGAL::do_intersect(cgal(first), cgal(second));
    CHECK((distance == 0) == meets);
    crossings += meets ? 1 : 0;
  }
  CHECK(crossings > 30);
  CHECK(crossings < 250);
}

TEST_CASE("a vertex star may move up to the gap, and no farther") {
  const Mesh ceiling = test::moved(test::grid(4), Vec3(-0.5, -0.5, 1));
  Mesh wide = ceiling;
  for (Vec3& p : wide.positions) p = Vec3(8 * p.x(), 8 * p.y(), 1);
  const KeepOut keep_out({&wide, 0.25});
  const auto flat = star(Vec3::Zero());
  CHECK(keep_out.allows(star(Vec3(0, 0, 0.74)), flat));
  CHECK(!keep_out.allows(star(Vec3(0, 0, 0.76)), flat));
  CHECK(!keep_out.allows(star(Vec3(0, 0, 1.5)), flat));
  CHECK(keep_out.allows(star(Vec3(0, 0, -2)), flat));
  // Faces that are too near already may move away or sideways, but not nearer.
  const auto near = star(Vec3(0, 0, 0.9));
  CHECK(keep_out.allows(star(Vec3(0, 0, 0.85)), near));
  CHECK(keep_out.allows(star(Vec3(0.1, 0, 0.9)), near));
  CHECK(!keep_out.allows(star(Vec3(0, 0, 0.91)), near));
  CHECK(keep_out.distance(flat[0], 5) == Approx(1));
  CHECK(keep_out.distance(flat[0], 0.5) == 0.5);
}

TEST_CASE("faces do not pass over a body that is smaller than the step") {
  const Mesh pebble = test::moved(test::scaled(test::icosphere(1), 0.05), Vec3(0.1, 0.1, 0.5));
  const KeepOut keep_out({&pebble, 0.01});
  const auto flat = star(Vec3::Zero());
  CHECK(!keep_out.allows(star(Vec3(0, 0, 3)), flat));
  CHECK(!keep_out.allows(flat, star(Vec3(0, 0, 3))));
  CHECK(keep_out.allows(star(Vec3(0, 0, -3)), flat));
  CHECK(keep_out.allows(star(Vec3(0, 0, 0.2)), flat));

  // The same checks for a triangle that moves as a whole.
  const Triangle before{Vec3(-1, -1, 0), Vec3(2, -1, 0), Vec3(0, 2, 0)};
  for (const double height : {0.2, 3.0}) {
    const Triangle after = moved(before, Vec3(0, 0, height));
    std::vector<Triangle> sides;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      sides.push_back({before[i], before[j], after[j]});
      sides.push_back({before[i], after[j], after[i]});
    }
    CHECK(keep_out.allows({&after, 1}, {&before, 1}, sides) == (height < 1));
  }
}

TEST_CASE("faces that are too close are counted, and intersecting ones refused") {
  const Mesh ball = test::icosphere(2);
  const Mesh other = test::moved(ball, Vec3(2.1, 0, 0));
  const std::size_t near = KeepOut({&other, 0.2}).count_near(ball);
  CHECK(near > 0);
  CHECK(near < ball.faces.size() / 10);
  CHECK(KeepOut({&other, 0.05}).count_near(ball) == 0);
  const Mesh crossing = test::moved(ball, Vec3(1.5, 0, 0));
  CHECK_THROWS_AS(KeepOut({&crossing, 0.1}).count_near(ball), InputError);
  CHECK_THROWS_AS(KeepOut({&other, 0}), UsageError);
  CHECK_THROWS_AS(KeepOut({&other, std::nan("")}), UsageError);
}
