#include "transformesh/photo_step.h"

#include <doctest/doctest.h>

#include "helpers/ball_photographs.h"
#include "transformesh/errors.h"
#include "views/photo/photo_scene.h"
#include "views/photo/scene_step.h"

using namespace transformesh;
using namespace transformesh::test;
using doctest::Approx;

TEST_CASE("movements are clamped, and with alpha 0 there are none") {
  const PhotoScene scene = photo_scene(ring(), 2);
  Mesh mesh = ball(1.02);
  PhotoStepOptions options;
  options.alpha = 0.01;
  const PhotoStepResult clamped = photo_step(mesh, scene, options);
  CHECK(clamped.displaced.clamped > 0);
  CHECK(clamped.displaced.max_clamp_share == Approx(1));
  CHECK(clamped.mean_share <= 0.01 + 1e-12);
  options.alpha = 0;
  const Mesh before = mesh;
  CHECK(photo_step(mesh, scene, options).displaced.moved == 0);
  CHECK(mesh.positions == before.positions);
}

TEST_CASE("the paper's step is t times the derivative per area, and then smooths") {
  const PhotoScene scene = photo_scene(ring(), 1);
  PhotoStepOptions options;
  options.rule = PhotoStepRule::gradient;
  options.alpha = 10;
  options.smoothing = 0;
  const auto longest = [&](double time_step) {
    Mesh mesh = ball(1.02);
    options.time_step = time_step;
    return photo_step(mesh, scene, options).displaced.max_displacement;
  };
  CHECK(longest(1e-7) > 0);
  CHECK(longest(2e-7) == Approx(2 * longest(1e-7)));
  Mesh mesh = ball(1.02);
  options.time_step = 0;
  options.smoothing = 1;
  photo_step(mesh, scene, options);
  CHECK(mesh.positions[50].norm() < 1.02);
}

TEST_CASE("a step reports measures from before the movement") {
  const PhotoScene scene = photo_scene(ring(1, true), 2);
  Mesh mesh = ball(1.1);
  PhotoStepOptions still;
  still.alpha = 0;
  const PhotoStepResult before = photo_step(mesh, scene, still);
  const PhotoStepResult result = photo_step(mesh, scene);
  CHECK(result.energy == before.energy);
  CHECK(result.pixels == before.pixels);
  CHECK(result.outside == before.outside);
  CHECK(result.outside > 0);
  CHECK(result.coverage > 0.5);
  CHECK(result.coverage <= 1);
  CHECK(result.dissimilarity > 0);
  CHECK(result.mean_share > 0);
  // Cameras point along the equator, so the poles are visible only at grazing angles.
  CHECK(result.unseen > 0);
  CHECK(result.unseen < mesh.positions.size() / 4);
}

TEST_CASE("stiffness keeps a step smooth, damping keeps it short") {
  const PhotoScene scene = photo_scene(ring(), 2);
  const auto moved = [&](const PhotoStepOptions& options) {
    Mesh mesh = ball(1.03);
    photo_step(mesh, scene, options);
    return mesh;
  };
  const auto roughness = [](const Mesh& mesh) {
    double sum = 0;
    for (const Face& face : mesh.faces)
      sum += std::abs(mesh.positions[face[0]].norm() - mesh.positions[face[1]].norm());
    return sum;
  };
  PhotoStepOptions options;
  options.stiffness = 0.1;
  const double soft = roughness(moved(options));
  options.stiffness = 10;
  CHECK(roughness(moved(options)) < 0.7 * soft);
  options = {};
  const double usual = error(ball(1.03), 1) - error(moved(options), 1);
  options.damping = 10;
  CHECK(error(ball(1.03), 1) - error(moved(options), 1) < 0.5 * usual);
}

TEST_CASE("hidden surfaces and options out of range are refused") {
  const PhotoScene scene = photo_scene(ring(), 4);
  Mesh far = ball(1);
  for (Vec3& p : far.positions) p.y() += 100;
  CHECK_THROWS_AS(photo_step(far, scene), InputError);
  Mesh mesh = ball(1);
  for (double PhotoStepOptions::*member :
       {&PhotoStepOptions::stiffness, &PhotoStepOptions::damping, &PhotoStepOptions::time_step,
        &PhotoStepOptions::silhouettes, &PhotoStepOptions::least_cosine,
        &PhotoStepOptions::smoothing}) {
    PhotoStepOptions options;
    options.*member = -1;
    CHECK_THROWS_AS(photo_step(mesh, scene, options), UsageError);
  }
}
