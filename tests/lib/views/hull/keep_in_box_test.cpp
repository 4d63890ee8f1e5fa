#include "views/hull/keep_in_box.h"

#include <doctest/doctest.h>

#include <cmath>

#include "transformesh/errors.h"
#include "views/cameras/view.h"

using namespace transformesh;

namespace {

/// Looks along z from a distance of 5 with focal length 50: pixel = 32 + 50 x / z.
View bright_view(bool is_packed) {
  View view;
  view.name = "bright";
  view.camera.intrinsics << 50, 0, 32, 0, 50, 24, 0, 0, 1;
  view.camera.translation = Vec3(0, 0, 5);
  GrayImage bright(64, 48);
  std::fill(bright.pixels.begin(), bright.pixels.end(), 200.0F);
  view.image = bright;
  view.silhouette = bright;
  if (is_packed) view.image.pack();
  return view;
}

}  // namespace

TEST_CASE("pixels outside of the box become background, except for a margin of a pixel") {
  for (const bool is_packed : {false, true}) {
    std::vector<View> views{bright_view(is_packed)};
    // The nearest side is at z 4: from pixel 32 - 12.5 to 32 + 25, and 24 - 6.25 to 24 + 12.5.
    keep_in_box(views, {Vec3(-1, -0.5, -1), Vec3(2, 1, 1)});
    CHECK(views[0].image.is_packed() == is_packed);
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        const bool is_kept = x >= 20 - 1 && x <= 57 + 1 && y >= 18 - 1 && y <= 36 + 1;
        const PackableImage& image = views[0].image;
        CHECK(image.at(x, y) == (is_kept ? 200 : 0));
        CHECK(GrayImage(views[0].silhouette).at(x, y) == (is_kept ? 200 : 0));
      }
    }
  }
}

TEST_CASE("for a camera inside the box all pixels stay, and missing images stay missing") {
  std::vector<View> views{bright_view(false)};
  views[0].silhouette = PackableImage();
  keep_in_box(views, {Vec3(-9, -9, -9), Vec3(9, 9, 9)});
  CHECK(views[0].silhouette.empty());
  const GrayImage image = views[0].image;
  CHECK(std::count(image.pixels.begin(), image.pixels.end(), 200.0F) == 64 * 48);
}

TEST_CASE("a box that a view does not show, or without an inside, is refused") {
  std::vector<View> views{bright_view(false)};
  CHECK_THROWS_WITH_AS(
      keep_in_box(views, {Vec3(50, 0, 0), Vec3(51, 1, 1)}),
      "bright: the box is outside this view; check that its units are those of the cameras",
      InputError);
  CHECK_THROWS_AS(keep_in_box(views, {Vec3(0, 0, 0), Vec3(1, 0, 1)}), UsageError);
  CHECK_THROWS_AS(keep_in_box(views, {Vec3(1, 1, 1), Vec3(0, 0, 0)}), UsageError);
  CHECK_THROWS_AS(keep_in_box(views, {Vec3(0, 0, 0), Vec3(1, HUGE_VAL, 1)}), UsageError);
}
