#include "tm/views/photo/photo_steps.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "helpers/shapes.h"
#include "tm/support/error.h"
#include "tm/support/parallel.h"

using namespace transformesh;
using doctest::Approx;

namespace {

float texture(const Vec3& p) {
  const double sum = std::sin(17 * p.x() + 3) + std::sin(15 * p.y() + 5 * p.z()) +
                     std::sin(19 * p.z() - 4 * p.x()) + std::sin(11 * (p.x() + p.y() - p.z()));
  return static_cast<float>(128 + 25 * sum);
}

/// A camera on a ring around the unit sphere, and what it sees: traced, not rasterized.
View photograph(double angle_deg, double size) {
  View view;
  view.camera.intrinsics << 260, 0, 79.5, 0, 260, 79.5, 0, 0, 1;
  view.camera.rotation =
      Eigen::AngleAxisd(angle_deg * std::numbers::pi / 180, Vec3::UnitY()).toRotationMatrix();
  view.camera.translation = {0, 0, 5 * size};
  view.image = view.silhouette = GrayImage(160, 160);
  const Vec3 eye = view.camera.center() / size;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      const Vec3 ray = view.camera.ray(x, y).normalized();
      const double along = -eye.dot(ray);
      const double inside = 1 - (eye + along * ray).squaredNorm();
      if (inside < 0) continue;
      view.image.at(x, y) = texture(eye + (along - std::sqrt(inside)) * ray);
      view.silhouette.at(x, y) = 255;
    }
  }
  return view;
}

std::vector<View> ring(double size = 1, bool with_silhouettes = false) {
  std::vector<View> views;
  for (int i = 0; i < 16; ++i) {
    views.push_back(photograph(22.5 * i, size));
    if (!with_silhouettes) views.back().silhouette = GrayImage();
  }
  return views;
}

Mesh ball(double radius) {
  Mesh mesh = test::icosphere(4);
  for (Vec3& p : mesh.positions) p *= radius;
  return mesh;
}

/// Mean distance to a sphere, near the equator, where all cameras look.
double error(const Mesh& mesh, double radius) {
  double sum = 0;
  int count = 0;
  for (const Vec3& p : mesh.positions) {
    if (std::abs(p.y()) > 0.6 * p.norm()) continue;
    sum += std::abs(p.norm() - radius);
    ++count;
  }
  return sum / count;
}

}  // namespace

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

TEST_CASE("one order of the pairs after the other is as good") {
  const PhotoScene scene = photo_scene(ring(), 2);
  Mesh mesh = ball(1.05);
  const PhotoStepsResult result = photo_steps(mesh, scene, {{}, 12, true});
  CHECK(error(mesh, 1) < 0.3 * scene.pixel);
  Mesh again = ball(1.05);
  const std::size_t both = photo_steps(again, scene).first.pixels;
  CHECK(static_cast<double>(result.first.pixels) < 0.6 * static_cast<double>(both));
}

TEST_CASE("a robust loss minds less what photographs show that is not on the surface") {
  // Speckles that stay where they are in every photograph, as dirt on a lens.
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

TEST_CASE("silhouettes bring back what photographs cannot judge") {
  // Without texture there is nothing to compare.
  std::vector<View> views = ring(1, true);
  for (View& view : views) {
    for (float& level : view.image.pixels) level = 90;
  }
  const PhotoScene scene = photo_scene(views, 1);
  for (const double start : {0.95, 1.05}) {
    Mesh mesh = ball(start);
    const PhotoStepsResult result = photo_steps(mesh, scene, {{}, 20, false});
    CHECK(error(mesh, 1) < 0.4 * error(ball(start), 1));
    CHECK((result.first.outside > 0) == (start > 1));
  }
  // The paper's step knows no plate that carries the pull from the rims to what lies between.
  PhotoStepOptions paper;
  paper.rule = PhotoStepRule::gradient;
  paper.smoothing = 0;
  Mesh mesh = ball(1.05);
  photo_steps(mesh, scene, {paper, 5, false});
  CHECK(error(mesh, 1) < 0.3 * error(ball(1.05), 1));
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
  // Eyes that look at a large ball see less of it as it shrinks into its silhouettes.
  const PhotoScene scene = photo_scene(ring(1, true), 1);
  Mesh mesh = ball(1.15);
  PhotoStepOptions options;
  options.silhouettes = 100;
  const PhotoStepsResult result = photo_steps(mesh, scene, {options, 12, false});
  CHECK(result.last.pixels < 0.9 * result.first.pixels);
  CHECK(result.last.coverage > 0.98 * result.first.coverage);
  CHECK_FALSE(result.lost_coverage);
}

TEST_CASE("coverage that goes is told") {
  // Steps far too long crumple the ball: its spikes hide one another from the other views.
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

TEST_CASE("views that cannot be compared are refused, and options out of range") {
  std::vector<View> views = ring();
  PairOptions pairs;
  pairs.maximum_angle_deg = 10;
  CHECK_THROWS_AS(photo_scene(views, 1, pairs), InputError);
  const PhotoScene scene = photo_scene(views, 4);
  Mesh far = ball(1);
  for (Vec3& p : far.positions) p.y() += 100;
  CHECK_THROWS_AS(photo_step(far, scene), InputError);
  Mesh mesh = ball(1);
  PhotoStepOptions options;
  options.stiffness = -1;
  CHECK_THROWS_AS(photo_step(mesh, scene, options), UsageError);
  CHECK_THROWS_AS(photo_steps(mesh, scene, {{}, 0, false}), UsageError);
}
