#include "views/hull/agreed_threshold.h"

#include <doctest/doctest.h>

#include "helpers/intensities.h"
#include "helpers/view_maker.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"
#include "views/hull/silhouette.h"

using namespace transformesh;
using namespace view_maker;

namespace {

constexpr double radius = 60;

/// Returns the distance along a ray from `eye` to the ball; negative if the ray misses it.
double hit(const Vec3& eye, const Vec3& ray) {
  const double along = -eye.dot(ray);
  const double inside = radius * radius - (eye + along * ray).squaredNorm();
  return inside < 0 ? -1 : along - std::sqrt(inside);
}

/// A ball of intensity 160 with two dark caps of its own, before a background of up to 6.
View photograph(const Vec3& eye, float cap_intensity) {
  View view;
  view.name = "ball";
  view.camera = camera_at(eye);
  view.image = GrayImage(320, 240);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const Vec3 ray = view.camera.ray(x, y).normalized();
      const double along = hit(eye, ray);
      const Vec3 point = (eye + along * ray) / radius;
      const bool is_dark = point.dot(Vec3(1, 1, 0.3).normalized()) > 0.9 || point.y() < -0.9;
      view.image.at(x, y) =
          along < 0 ? static_cast<float>((5 * x + 3 * y) % 7) : (is_dark ? cap_intensity : 160.0F);
    }
  }
  return view;
}

std::vector<View> photographs(float cap_intensity) {
  std::vector<View> views;
  for (const Vec3& eye : ring_of_eyes(8, 500, 20)) views.push_back(photograph(eye, cap_intensity));
  return views;
}

double intensity_of_all(const std::vector<View>& views) {
  std::vector<GrayImage> images;
  for (const View& view : views) images.push_back(view.image);
  return dividing_threshold(images);
}

}  // namespace

TEST_CASE("dark parts of the object belong to it, according to the other views") {
  const std::vector<View> views = photographs(35);
  CHECK(intensity_of_all(views) > 60);
  const double intensity = agreed_threshold(views);
  CHECK(intensity > 6);
  CHECK(intensity < 35);
}

TEST_CASE("a bright background that one view shows does not") {
  std::vector<View> views = photographs(60);
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 60; ++x) views[2].image.at(x, y) = 38;
  const double intensity = agreed_threshold(views);
  CHECK(intensity > 38);
  CHECK(intensity < 60);
}

TEST_CASE(
    "of equally good intensities the highest is chosen; views without photograph do not matter") {
  std::vector<View> views = photographs(160);
  const double intensity = agreed_threshold(views);
  CHECK(intensity == doctest::Approx(intensity_of_all(views)));
  View without = views[0];
  without.image = GrayImage();
  views.push_back(without);
  CHECK(agreed_threshold(views) == intensity);
}

TEST_CASE("the same for any number of threads") {
  const std::vector<View> views = photographs(35);
  const double intensity = agreed_threshold(views);
  const ThreadLimit limit(1);
  CHECK(agreed_threshold(views) == intensity);
}

TEST_CASE("where there is no hull the intensity is the dividing one; without photographs none") {
  std::vector<View> views = photographs(160);
  for (View& view : views) test::change_intensities(view.image, [](float) { return 200.0F; });
  views[0].image.at(0, 0) = 10;
  CHECK(agreed_threshold(views) == doctest::Approx(105));
  for (View& view : views) view.image = GrayImage();
  CHECK_THROWS_AS(agreed_threshold(views), UsageError);
}

TEST_CASE("views get the silhouettes of one intensity, which the hull agrees with") {
  std::vector<View> views = photographs(35);
  const double intensity = threshold_silhouettes(views);
  CHECK(intensity == agreed_threshold(photographs(35)));
  Mesh hull = visual_hull(views, {.resolution = 40}).mesh;
  for (const double agreement : silhouette_agreements(hull, views)) CHECK(agreement > 0.97);
  for (Vec3& point : hull.positions) point *= 0.8;
  for (const double agreement : silhouette_agreements(hull, views)) {
    CHECK(agreement > 0.55);
    CHECK(agreement < 0.7);
  }
  CHECK(threshold_silhouettes(views, {.intensity = 100}) == 100);
}
