#include "transformesh/hull.h"

#include <doctest/doctest.h>

#include "helpers/intensities.h"
#include "helpers/mesh_facts.h"
#include "helpers/view_maker.h"
#include "support/parallel.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"

using namespace transformesh;
using namespace view_maker;

namespace {

std::vector<View> views_of_ball(const std::vector<Vec3>& eyes, const Vec3& center, double radius,
                                const Frame& frame = {}) {
  std::vector<View> views;
  for (const Vec3& eye : eyes) views.push_back(ball_view(eye, center, radius, frame));
  return views;
}

void check_surface(const Mesh& mesh) {
  const test::Count count = test::count(mesh);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(find_intersections(mesh).empty());
}

/// Returns how far a point lies outside of a cone around a ball, in units of the world.
double beyond_cone(const Vec3& eye, const Vec3& center, double radius, const Vec3& point) {
  const Vec3 ray = point - eye;
  return ball_contour(eye, center, radius)(ray.normalized()) * ray.norm();
}

}  // namespace

TEST_CASE("every vertex of a ball's hull lies on a cone, and within all others") {
  const Vec3 center(4, -3, 2);
  const std::vector<Vec3> eyes = ring_of_eyes(9, 500, 25);
  const HullResult result = visual_hull(views_of_ball(eyes, center, 60), {.resolution = 60});
  check_surface(result.mesh);
  CHECK(connected_components(result.mesh).components.size() == 1);
  CHECK(result.dropped_components == 0);
  int close = 0;
  for (const Vec3& position : result.mesh.positions) {
    double farthest = -1e9;
    for (const Vec3& eye : eyes)
      farthest = std::max(farthest, beyond_cone(eye, center, 60, position));
    // A cell is 2 long, a pixel 0.8; cells cut off the edges between cones.
    CHECK(farthest < 0.3);
    CHECK(farthest > -2);
    close += std::abs(farthest) < 0.15 ? 1 : 0;
    CHECK((position - center).norm() > 60 - 0.2);
  }
  CHECK(close > 0.9 * static_cast<double>(result.mesh.positions.size()));
}

TEST_CASE("values are cut off at four cells, and 0 on the hull") {
  const Vec3 center(4, -3, 2);
  const std::vector<View> views = views_of_ball(ring_of_eyes(9, 500, 25), center, 60);
  const ValueGrid grid = hull_values(views, {.resolution = 40});
  const auto [least, most] = std::minmax_element(grid.values.begin(), grid.values.end());
  CHECK(*least == doctest::Approx(-4 * grid.spacing));
  CHECK(*most == doctest::Approx(4 * grid.spacing));
  CHECK(march_tetrahedra(grid).positions == visual_hull(views, {.resolution = 40}).mesh.positions);
}

TEST_CASE("three far away cameras see the solid of three cylinders") {
  const Frame frame{200, 200, 20000};
  const std::vector<Vec3> eyes = {{10000, 0, 0}, {0, 10000, 0}, {0, 0, 10000}};
  const HullResult result =
      visual_hull(views_of_ball(eyes, Vec3::Zero(), 40, frame), {.resolution = 80});
  check_surface(result.mesh);
  const double exact = 8 * (2 - std::sqrt(2.0)) * 40 * 40 * 40;  // volume of Steinmetz's solid
  CHECK(volume(result.mesh) == doctest::Approx(exact).epsilon(0.01));
}

TEST_CASE("a box seen along its axes is its own hull") {
  const Frame frame{200, 200, 20000};
  const Vec3 half(30, 20, 10);
  std::vector<View> views;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 eye = 10000 * Vec3::Unit(axis);
    const auto contour = [&](const Vec3& ray) {
      const Vec3 hit = eye + ray * (10000 / -ray[axis]);
      double beyond = -1e9;
      for (int other = 0; other < 3; ++other)
        if (other != axis) beyond = std::max(beyond, std::abs(hit[other]) - half[other]);
      return beyond / 10000;
    };
    views.push_back(view_of(camera_at(eye, frame), frame, contour));
  }
  const HullResult result = visual_hull(views, {.edge = 0.7});
  const Box box = bounding_box(result.mesh);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(box.max()[axis] == doctest::Approx(half[axis]).epsilon(0.02));
    CHECK(box.min()[axis] == doctest::Approx(-half[axis]).epsilon(0.02));
  }
  CHECK(volume(result.mesh) == doctest::Approx(8 * half.prod()).epsilon(0.03));
  CHECK(result.cell == 0.7);
}

TEST_CASE("space outside of an image is not carved") {
  // The ball leaves the images of two cameras: the third one still bounds it, and the hull extends
  // beyond the two images.
  const std::vector<Vec3> eyes = ring_of_eyes(8, 400, 20);
  std::vector<View> views = views_of_ball(eyes, Vec3::Zero(), 50);
  const double volume_seen = volume(visual_hull(views, {.resolution = 50}).mesh);
  const Frame narrow{60, 240, 600};
  views[0] = ball_view(eyes[0], Vec3::Zero(), 50, narrow);
  views[3] = ball_view(eyes[3], Vec3::Zero(), 50, narrow);
  const HullResult partly = visual_hull(views, {.resolution = 50});
  check_surface(partly.mesh);
  CHECK(volume(partly.mesh) > 0.99 * volume_seen);
  CHECK(volume(partly.mesh) < 1.2 * volume_seen);

  // A single view does not bound the hull, so the box does.
  const std::vector<View> single = {views[0]};
  const Box box{Vec3::Constant(-70), Vec3::Constant(70)};
  const HullResult cut = visual_hull(single, {.box = box, .edge = 4});
  check_surface(cut.mesh);
  CHECK(bounding_box(cut.mesh).max().x() == doctest::Approx(70).epsilon(0.06));
}

TEST_CASE("skipping blocks of cells changes nothing: cells of any size agree about a far point") {
  // Two balls of very different size: the small one is smaller than a block.
  const std::vector<Vec3> eyes = ring_of_eyes(8, 500, 25);
  std::vector<View> views = views_of_ball(eyes, {-30, 0, 0}, 30);
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    const View small = ball_view(eyes[i], {55, 10, 20}, 4);
    for (int y = 0; y < small.silhouette.height; ++y)
      for (int x = 0; x < small.silhouette.width; ++x) {
        float& intensity = views[i].silhouette.at(x, y);
        intensity = std::max(intensity, small.silhouette.at(x, y));
      }
  }
  const HullResult all = visual_hull(views, {.resolution = 90, .keep = 0});
  bool is_found = false;
  for (const Component& part : connected_components(all.mesh).components)
    is_found = is_found || std::abs(part.volume - 4.0 / 3 * 3.14159 * 64) < 110;
  CHECK(is_found);
  CHECK(bounding_box(all.mesh).max().x() == doctest::Approx(59).epsilon(0.03));

  const HullResult largest = visual_hull(views, {.resolution = 90, .keep = 1});
  CHECK(connected_components(largest.mesh).components.size() == 1);
  CHECK(largest.dropped_components + 1 == connected_components(all.mesh).components.size());
  CHECK(bounding_box(largest.mesh).max().x() < 10);
}

TEST_CASE("the same hull for any number of threads") {
  const std::vector<View> views = views_of_ball(ring_of_eyes(6, 500, 25), Vec3::Zero(), 60);
  const HullResult several = visual_hull(views, {.resolution = 40});
  const ThreadLimit one(1);
  const HullResult single = visual_hull(views, {.resolution = 40});
  CHECK(single.mesh.faces == several.mesh.faces);
  CHECK(single.mesh.positions == several.mesh.positions);
}

TEST_CASE("options and views that make no sense are refused") {
  const std::vector<View> views = views_of_ball(ring_of_eyes(6, 500, 25), Vec3::Zero(), 60);
  CHECK_THROWS_AS(visual_hull(views, {.resolution = 3}), UsageError);
  CHECK_THROWS_AS(visual_hull(views, {.edge = 0.0}), UsageError);
  CHECK_THROWS_AS(visual_hull(views, {.edge = 0.01}), UsageError);
  CHECK_THROWS_AS(visual_hull(views, {.keep = 2}), UsageError);
  CHECK_THROWS_AS(visual_hull(views, {.box = Box{Vec3::Ones(), Vec3::Zero()}}), UsageError);
  CHECK_THROWS_AS(visual_hull(std::vector<View>(2)), InputError);
  const Box beside{Vec3(80, 80, 0), Vec3(90, 90, 10)};
  CHECK_THROWS_AS(visual_hull(views, {.box = beside}), InputError);
}
