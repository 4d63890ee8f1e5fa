#include "views/depth/viewed_region.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/view_maker.h"

using namespace transformesh;

namespace {

const view_maker::Frame frame{80, 60, 60};

std::vector<View> ring() {
  std::vector<View> views;
  for (const Vec3& eye : view_maker::ring_of_eyes(8, 5, 25)) {
    View view;
    view.camera = view_maker::camera_at(eye, frame);
    view.image = GrayImage(frame.width, frame.height);
    views.push_back(view);
  }
  return views;
}

float value_at(const ValueGrid& region, const Vec3& point) {
  const Vec3 at = (point - region.origin) / region.spacing;
  return region.values[region.index(static_cast<std::size_t>(at.x() + 0.5),
                                    static_cast<std::size_t>(at.y() + 0.5),
                                    static_cast<std::size_t>(at.z() + 0.5))];
}

}  // namespace

TEST_CASE("without box, the region is around the viewed point and nearer than the cameras") {
  const std::vector<View> views = ring();
  const ValueGrid region = viewed_region(views, std::nullopt);
  CHECK(value_at(region, Vec3::Zero()) < 0);
  const Box box = box_of(region);
  CHECK(box.contains(Vec3::Zero()));
  for (const View& view : views) CHECK_FALSE(box.contains(view.camera.center()));
  CHECK(box.max().cwiseAbs().maxCoeff() < 3.1);
}

TEST_CASE("points that fewer than three views show do not belong to a given box") {
  std::vector<View> views = ring();
  const Box box(Vec3(-1, -1, -1), Vec3(1, 1, 100));
  const ValueGrid region = viewed_region(views, box);
  CHECK(value_at(region, Vec3::Zero()) < 0);
  CHECK(value_at(region, Vec3(0, 0, 90)) > 0);
  CHECK(box_of(region).max().z() < 50);
  views.resize(2);  // two views are enough if there are no more
  CHECK(value_at(viewed_region(views, box), Vec3::Zero()) < 0);
}

TEST_CASE("a box that no view shows is refused") {
  CHECK_THROWS_AS(viewed_region(ring(), Box(Vec3(900, 900, 900), Vec3(901, 901, 901))), InputError);
}

TEST_CASE("the box of sparse points does not follow outliers") {
  test::Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 3));
  for (int i = 0; i < 10; ++i) points.emplace_back(random.uniform(50, 900), -70, 1000);
  const auto box = box_of_points(points);
  REQUIRE(box);
  CHECK(box->contains(Vec3(0.98, -0.98, 2.95)));
  CHECK(box->max().maxCoeff() < 4);
  points.resize(99);
  CHECK_FALSE(box_of_points(points));
}
