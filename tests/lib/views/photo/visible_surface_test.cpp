#include "views/photo/visible_surface.h"

#include <doctest/doctest.h>

#include "helpers/ball_photographs.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

/// Returns the distance along the optical axis to the unit sphere, for the photograph of ring() at
/// angle 0.
double depth_of_sphere(const View& view, int x, int y) {
  const Vec3 eye = view.camera.center(), ray = view.camera.ray(x, y).normalized();
  const double along = -eye.dot(ray);
  const double inside = 1 - (eye + along * ray).squaredNorm();
  if (inside < 0) return 0;
  const Vec3 point = eye + (along - std::sqrt(inside)) * ray;
  return (view.camera.rotation * point + view.camera.translation).z();
}

}  // namespace

TEST_CASE("depths of a sphere are those of its equation, and facing those of its normals") {
  const Mesh mesh = test::icosphere(5);
  const std::vector<View> views{test::photograph(0, 1)};
  const SeenViews seen(mesh, views, .3);
  VisibleSurface room;
  const VisibleSurface& surface = seen.surface(0, room);
  int compared = 0;
  for (int y = 0; y < surface.box.rows(); ++y)
    for (int x = 0; x < surface.box.columns(); ++x) {
      const int column = surface.box.first_column + x, row = surface.box.first_row + y;
      const double depth = surface.depth.at(x, y);
      if (depth == 0) continue;
      ++compared;
      CHECK(depth == doctest::Approx(depth_of_sphere(views[0], column, row)).epsilon(.002));
      CHECK(surface.inverse_facing.at(x, y) < 0);
      // The cosine between ray and normal is at least 0.3.
      const Vec3 ray = views[0].camera.ray(column, row);
      CHECK(-1 / surface.inverse_facing.at(x, y) >= .3 * ray.norm() * .999);
    }
  CHECK(compared > 4000);
}

TEST_CASE("a threshold of the cosine excludes faces at grazing angles") {
  const Mesh mesh = test::icosphere(4);
  const std::vector<View> views{test::photograph(0, 1)};
  const auto count = [&](double least_cosine) {
    VisibleSurface room;
    const SeenViews seen(mesh, views, least_cosine);
    const VisibleSurface& surface = seen.surface(0, room);
    return std::ranges::count_if(surface.depth.pixels, [](float depth) { return depth > 0; });
  };
  CHECK(count(.9) < count(.5));
  CHECK(count(.5) < count(0));
}

TEST_CASE("backs of faces are not compared") {
  const std::vector<View> views{test::photograph(0, 1)};
  const Mesh mesh = test::reversed(test::icosphere(3));
  VisibleSurface room;
  const SeenViews seen(mesh, views, 0);
  // The far side of the sphere faces the camera; its contour has the depth 4.8.
  const VisibleSurface& surface = seen.surface(0, room);
  for (int y = 0; y < surface.box.rows(); ++y)
    for (int x = 0; x < surface.box.columns(); ++x)
      if (surface.depth.at(x, y) > 0) CHECK(surface.depth.at(x, y) > 4.75);
}
