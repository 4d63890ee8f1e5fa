/// Signs of volumes of plates that are a few roundings thick, compared with rational arithmetic.
#include "geometry/inward_components.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "helpers/random.h"
#include "helpers/rational.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// Returns a rotated plate of size 1 whose thickness is 0 before rounding. Its volume is that of
/// rounding errors.
Mesh flat_plate(test::Random& random) {
  Mesh plate = test::cuboid({0, 0, 0}, {1, 1, 1e-16});
  const Eigen::AngleAxisd turn(random.uniform(0, 3), random.point(-1, 1).normalized());
  const Vec3 place = random.point(-3, 3);
  for (Vec3& p : plate.positions) p = turn * p + place;
  return plate;
}

test::Rational six_volumes(const Mesh& mesh) {
  test::Rational sum = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto [a, b, c] = test::exact_triangle(mesh, f);
    sum += test::dot(a, test::cross(b, c));
  }
  return sum;
}

bool is_inward(const Mesh& mesh) {
  return inward_components(mesh, connected_components(mesh)).at(0) != 0;
}

}  // namespace

TEST_CASE("signs of volumes of the size of rounding errors are exact") {
  test::Random random(1);
  int differs = 0;
  for (int round = 0; round < 500; ++round) {
    const Mesh plate = flat_plate(random);
    const test::Rational exact = six_volumes(plate);
    CAPTURE(round);
    CHECK(is_inward(plate) == (exact < 0));
    CHECK(is_inward(test::reversed(plate)) == (exact > 0));
    differs += (connected_components(plate).components[0].volume < 0) != (exact < 0) ? 1 : 0;
  }
  CHECK(differs > 0);  // otherwise the sums of doubles would have sufficed
}

TEST_CASE("only closed components that are inside out are inward") {
  Mesh open = test::icosphere(1);
  open.faces.pop_back();
  Mesh all = test::joined(test::icosphere(1), test::reversed(test::moved(open, {9, 0, 0})));
  all = test::joined(all, test::reversed(test::moved(test::icosphere(1), {5, 0, 0})));
  CHECK(inward_components(all, connected_components(all)) == std::vector<char>{0, 0, 1});
}

TEST_CASE("signs are exact where products of doubles underflow or overflow") {
  for (const double size : {1e-200, 1e200}) {
    const Mesh ball = test::scaled(test::icosphere(1), size);
    CHECK_FALSE(is_inward(ball));
    CHECK(is_inward(test::reversed(ball)));
  }
}
