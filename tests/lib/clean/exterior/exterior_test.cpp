/// Which pieces are kept, against winding numbers summed up from solid angles on both sides of
/// them.
#include "clean/exterior/exterior.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"
#include "mesh/components.h"
#include "mesh/measure.h"
#include "support/error.h"

namespace transformesh {
namespace {

Exterior exterior_of(const Arrangement& arrangement, int winding_level, ExteriorMethod method) {
  return find_exterior(arrangement, winding_level, method, BorderClosure(), Progress());
}

Mesh ball(double radius, const Vec3& center = Vec3::Zero()) {
  return test::moved(test::scaled(test::icosphere(2), radius), center);
}

}  // namespace

TEST_CASE(
    "a piece is kept where w < winding level in front of it and w >= winding level behind it") {
  std::size_t tested = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Mesh mesh = test::random_balls(seed, 5);
    const Arrangement arrangement = test::arranged(mesh);
    for (const int winding_level : {1, 2}) {
      CAPTURE(seed);
      CAPTURE(winding_level);
      const Exterior grown = exterior_of(arrangement, winding_level, ExteriorMethod::grow);
      const Exterior tested_all =
          exterior_of(arrangement, winding_level, ExteriorMethod::static_test);
      CHECK(grown.kept == tested_all.kept);
      CHECK(tested_all.rays == arrangement.pieces.size());
      CHECK(grown.rays < 10);
      for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
        const Triangle t = test::corners_of(arrangement, arrangement.pieces[p]);
        const std::optional<int> front = test::winding_beside(mesh, t, 1);
        const std::optional<int> behind = test::winding_beside(mesh, t, -1);
        if (!front || !behind) continue;
        REQUIRE(*behind == *front + arrangement.pieces[p].multiplicity);
        REQUIRE((grown.kept[p] == 1) == (*front < winding_level && *behind >= winding_level));
        ++tested;
        kept += grown.kept[p] == 1 ? 1 : 0;
      }
    }
  }
  CHECK(tested > 8000);
  CHECK(kept > 1000);
  CHECK(2 * kept < tested);
}

TEST_CASE("one ray fixes each connected set of patches") {
  Mesh mesh;
  for (int i = 0; i < 5; ++i) mesh = test::joined(mesh, ball(1, {3.0 * i, 0, 0}));
  const Exterior apart = exterior_of(test::arranged(mesh), 1, ExteriorMethod::grow);
  CHECK(apart.patches == 5);
  CHECK(apart.rays == 5);
  CHECK(std::count(apart.kept.begin(), apart.kept.end(), 1) == 5 * 320);

  // Each of four balls in a row has a circle in common with the next.
  Mesh row;
  for (int i = 0; i < 4; ++i) row = test::joined(row, ball(1, {1.5 * i, 0.01 * i, 0.007 * i * i}));
  const Exterior crossing = exterior_of(test::arranged(row), 1, ExteriorMethod::grow);
  CHECK(crossing.patches == 4 + 2 * 3);
  CHECK(crossing.rays == 1);
}

TEST_CASE("nothing to keep is told with its cause") {
  const auto message = [](const Mesh& mesh, int winding_level) {
    try {
      exterior_of(test::arranged(mesh), winding_level, ExteriorMethod::grow);
    } catch (const GoalError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message(test::cube(), 1).empty());
  CHECK(message(test::cube(), 2).starts_with("no winding number reaches 2"));
  CHECK(
      message(test::reversed(test::cube()), 1) ==
      "no point has a winding number >= 1: a difference without a remainder is empty; a mesh that "
      "is inside out is reversed by tm-stitch --flip");
  CHECK(message(test::joined(test::cube(), test::reversed(test::cube())), 1)
            .starts_with("the faces enclose nothing"));
}

TEST_CASE("the outermost surface has neither cavities nor what floats in them") {
  const Mesh shell = test::joined(ball(3), test::reversed(ball(2)));
  Mesh mesh = test::joined(test::joined(shell, ball(0.5, {0.3, 0, 0})), ball(1, {10, 0, 0}));
  CHECK(drop_enclosed_components(mesh) == 2);
  CHECK(connected_components(mesh).components.size() == 2);
  CHECK(volume(mesh) == doctest::Approx(volume(ball(3)) + volume(ball(1))));
  CHECK(drop_enclosed_components(mesh) == 0);

  // The ball within the cavity has a cavity of its own, with a ball in it.
  Mesh nested;
  for (int i = 0; i < 5; ++i) {
    const Mesh layer = ball(5 - i);
    nested = test::joined(nested, i % 2 == 1 ? test::reversed(layer) : layer);
  }
  CHECK(drop_enclosed_components(nested) == 4);
  CHECK(volume(nested) == doctest::Approx(volume(ball(5))));
}

}  // namespace transformesh
