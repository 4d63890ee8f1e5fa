#include "views/photo/photo_steps.h"

#include <doctest/doctest.h>

#include <array>

#include "helpers/ball_photographs.h"
#include "helpers/intensities.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "views/cameras/view.h"
#include "views/photo/photo_scene.h"

using namespace transformesh;
using namespace transformesh::test;
using doctest::Approx;

TEST_CASE("steps lead to the sphere, from inside and from outside, in any unit") {
  for (const double size : {1.0, 1e-3}) {
    const PhotoScene scene = photo_scene(ring(size), 2);
    CHECK(scene.pixel == Approx(size * 2 * 5 / 260));
    for (const double start : {0.95, 1.05}) {
      Mesh mesh = ball(start * size);
      const PhotoStepsResult result = photo_steps(mesh, scene, {{}, 12, false});
      CHECK(error(ball(start * size), size) > 1.2 * scene.pixel);
      CHECK(error(mesh, size) < 0.3 * scene.pixel);
      CHECK(result.last.dissimilarity < 0.7 * result.first.dissimilarity);
      CHECK(result.last.mean_share < result.first.mean_share);
      CHECK_FALSE(result.lost_coverage);
    }
  }
}

TEST_CASE("different orders of the pairs give equally good results") {
  const PhotoScene scene = photo_scene(ring(), 2);
  Mesh mesh = ball(1.05);
  const PhotoStepsResult result = photo_steps(mesh, scene, {{}, 12, true});
  CHECK(error(mesh, 1) < 0.3 * scene.pixel);
  Mesh again = ball(1.05);
  const std::size_t both = photo_steps(again, scene).first.pixels;
  CHECK(static_cast<double>(result.first.pixels) < 0.6 * static_cast<double>(both));
}

TEST_CASE("with momentum small steps get there in fewer, and a single one is as without") {
  const PhotoScene scene = photo_scene(ring(), 2);
  PhotoStepOptions small;
  small.damping = 3;
  const auto error_after = [&](int iterations, double momentum) {
    Mesh mesh = ball(1.05);
    photo_steps(mesh, scene, {small, iterations, true, momentum});
    return error(mesh, 1);
  };
  CHECK(error_after(1, 0.7) == error_after(1, 0));
  CHECK(error_after(6, 0.7) < 0.75 * error_after(6, 0));
  CHECK(error_after(10, 0.7) < error_after(16, 0));
  // The last step has no momentum, so the surface comes to rest.
  CHECK(error_after(30, 0.7) < 0.3 * scene.pixel);
  CHECK_THROWS_AS(error_after(2, 1), UsageError);
  CHECK_THROWS_AS(error_after(2, -0.1), UsageError);
}

TEST_CASE("a robust loss weakens objects in front of the surface") {
  // Speckles at the same pixels of every photograph, like dirt on a lens.
  std::vector<View> views = ring();
  for (View& view : views) {
    for (int y = 0; y < 160; ++y) {
      for (int x = 0; x < 160; ++x) {
        if (x % 20 < 4 && y % 20 < 4) view.image.at(x, y) = static_cast<float>(40 + 50 * (x % 4));
      }
    }
  }
  const PhotoScene scene = photo_scene(views, 1);
  std::array<double, 2> errors{};
  for (const bool is_robust : {false, true}) {
    Mesh mesh = ball(1.01);
    PhotoStepOptions options;
    options.photographs.correlation.robust = is_robust ? 0.1 : 0;
    photo_steps(mesh, scene, {options, 12, false});
    errors[is_robust ? 1 : 0] = error(mesh, 1);
  }
  CHECK(errors[1] < 0.7 * errors[0]);
}

TEST_CASE("silhouettes correct parts that photographs cannot measure") {
  // Without texture there is nothing to compare.
  std::vector<View> views = ring(1, true);
  for (View& view : views) test::change_intensities(view.image, [](float) { return 90.0F; });
  const PhotoScene scene = photo_scene(views, 1);
  for (const double start : {0.95, 1.05}) {
    Mesh mesh = ball(start);
    const PhotoStepsResult result = photo_steps(mesh, scene, {{}, 20, false});
    CHECK(error(mesh, 1) < 0.4 * error(ball(start), 1));
    CHECK((result.first.outside > 0) == (start > 1));
  }
  // The step of the paper has no thin-plate energy, which would carry the pull of the rims to the
  // parts in between.
  PhotoStepOptions paper;
  paper.rule = PhotoStepRule::gradient;
  paper.smoothing = 0;
  Mesh mesh = ball(1.05);
  photo_steps(mesh, scene, {paper, 5, false});
  CHECK(error(mesh, 1) < 0.3 * error(ball(1.05), 1));
}

TEST_CASE("the same bytes for any number of threads") {
  const PhotoScene scene = photo_scene(ring(1, true), 1.5);
  Mesh many = ball(1.02);
  Mesh one = many;
  PhotoStepOptions options;
  options.photographs.correlation.robust = 0.2;
  photo_steps(many, scene, {options, 2, true});
  const ThreadLimit limit(1);
  photo_steps(one, scene, {options, 2, true});
  CHECK(many.positions == one.positions);
}

TEST_CASE("a surface that becomes smaller keeps its coverage") {
  // Less of a large ball is visible as it shrinks into its silhouettes.
  const PhotoScene scene = photo_scene(ring(1, true), 1);
  Mesh mesh = ball(1.15);
  PhotoStepOptions options;
  options.silhouettes = 100;
  const PhotoStepsResult result = photo_steps(mesh, scene, {options, 12, false});
  CHECK(result.last.pixels < 0.9 * result.first.pixels);
  CHECK(result.last.coverage > 0.98 * result.first.coverage);
  CHECK_FALSE(result.lost_coverage);
}

TEST_CASE("lost coverage is reported") {
  // Steps that are far too long crumple the ball, so that its spikes hide each other in other
  // views.
  const PhotoScene scene = photo_scene(ring(), 1);
  Mesh mesh = ball(1.02);
  PhotoStepOptions options;
  options.rule = PhotoStepRule::gradient;
  options.time_step = 1;
  options.alpha = 2;
  options.smoothing = 0;
  const PhotoStepsResult result = photo_steps(mesh, scene, {options, 4, false});
  CHECK(result.last.coverage < 0.9 * result.first.coverage);
  CHECK(result.lost_coverage);
  CHECK(photo_steps(mesh, scene, {options, 1, false}).lost_coverage == false);
}

TEST_CASE("views that cannot be compared are refused, and less than one iteration") {
  const std::vector<View> views = ring();
  PairOptions pairs;
  pairs.maximum_angle_deg = 10;
  CHECK_THROWS_AS(photo_scene(views, 1, pairs), InputError);
  Mesh mesh = ball(1);
  CHECK_THROWS_AS(photo_steps(mesh, photo_scene(views, 4), {{}, 0, false}), UsageError);
}
