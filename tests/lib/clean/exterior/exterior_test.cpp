/// The pieces that are kept, compared with winding numbers by solid angles on both sides of each
/// piece.
#include "clean/exterior/exterior.h"

#include <doctest/doctest.h>

#include "helpers/arrangement_facts.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

Mesh ball(double radius, const Vec3& center = Vec3::Zero()) {
  return test::moved(test::scaled(test::icosphere(2), radius), center);
}

}  // namespace

TEST_CASE("the ray method keeps pieces at which the winding number passes the level") {
  std::size_t tested = 0, kept = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Mesh mesh = test::random_balls(seed, 5);
    const Arrangement arrangement = test::arranged(mesh);
    for (const int winding_level : {1, 2}) {
      CAPTURE(seed);
      CAPTURE(winding_level);
      const std::vector<char> found = find_exterior_by_rays(arrangement, winding_level, Progress());
      for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
        const Triangle t = test::corners_of(arrangement, arrangement.pieces[p]);
        const std::optional<int> front = test::winding_beside(mesh, t, 1);
        const std::optional<int> behind = test::winding_beside(mesh, t, -1);
        if (!front || !behind) continue;
        REQUIRE(*behind == *front + arrangement.pieces[p].multiplicity);
        REQUIRE((found[p] == 1) == (*front < winding_level && *behind >= winding_level));
        ++tested;
        kept += found[p] == 1 ? 1 : 0;
      }
    }
  }
  CHECK(tested > 8000);
  CHECK(kept > 1000);
  CHECK(2 * kept < tested);
}

TEST_CASE("the reason why nothing is kept depends on level, surface and borders") {
  WeldedMesh welded = weld(test::cube());
  CHECK(nothing_kept(welded, true, 2).sentence.starts_with("no point has a winding number >= 2"));
  CHECK(nothing_kept(welded, true, 1).kind == ErrorKind::no_positive_winding);
  CHECK(nothing_kept(welded, false, 1).kind == ErrorKind::canceling_faces);
  CHECK(nothing_kept(weld(Mesh()), false, 1).kind == ErrorKind::no_area);
  welded.open_component.assign(welded.faces.size(), 0);
  CHECK(nothing_kept(welded, true, 1).sentence.find("open mesh") != std::string::npos);
}

TEST_CASE("the outermost surface has no cavities and no components inside them") {
  const Mesh shell = test::joined(ball(3), test::reversed(ball(2)));
  Mesh mesh = test::joined(test::joined(shell, ball(0.5, {0.3, 0, 0})), ball(1, {10, 0, 0}));
  CHECK(drop_enclosed_components(mesh) == 2);
  CHECK(connected_components(mesh).components.size() == 2);
  CHECK(volume(mesh) == doctest::Approx(volume(ball(3)) + volume(ball(1))));
  CHECK(drop_enclosed_components(mesh) == 0);

  // The ball within the cavity has a cavity of its own, which contains a ball.
  Mesh nested;
  for (int i = 0; i < 5; ++i) {
    const Mesh layer = ball(5 - i);
    nested = test::joined(nested, i % 2 == 1 ? test::reversed(layer) : layer);
  }
  CHECK(drop_enclosed_components(nested) == 4);
  CHECK(volume(nested) == doctest::Approx(volume(ball(5))));
}
