#include <doctest/doctest.h>

#include "helpers/view_maker.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/hull_values.h"

using namespace transformesh;
using namespace view_maker;

namespace {

std::vector<View> views_of_ball(const std::vector<Vec3>& eyes, const Vec3& center, double radius) {
  std::vector<View> views;
  for (const Vec3& eye : eyes) views.push_back(ball_view(eye, center, radius));
  return views;
}

/// The bounding rectangle of all pixels inside, enlarged by one pixel.
struct Rectangle {
  Eigen::Array2d low = Eigen::Array2d::Constant(1e9);
  Eigen::Array2d high = Eigen::Array2d::Constant(-1e9);

  bool contains(const Eigen::Array2d& pixel) const {
    return (pixel >= low).all() && (pixel <= high).all();
  }
};

Rectangle rectangle_of(const GrayImage& silhouette) {
  Rectangle rectangle;
  for (int y = 0; y < silhouette.height; ++y) {
    for (int x = 0; x < silhouette.width; ++x) {
      if (silhouette.at(x, y) <= 127.5F) continue;
      rectangle.low = rectangle.low.min(Eigen::Array2d(x - 1, y - 1));
      rectangle.high = rectangle.high.max(Eigen::Array2d(x + 1, y + 1));
    }
  }
  return rectangle;
}

Eigen::Array2d projected(const View& view, const Vec3& point) {
  return (view.camera.projection() * point.homogeneous()).hnormalized().array();
}

}  // namespace

TEST_CASE("a ball seen from three far away places: its own box, a pixel wider") {
  const Vec3 center(1, -2, 3);
  const std::vector<Vec3> eyes = {{600, 0, 0}, {0, 600, 0}, {0, 0, 600}};
  const Box box = silhouette_box(views_of_ball(eyes, center, 40));
  for (int axis = 0; axis < 3; ++axis) {
    // A pixel is about 1 long here; perspective adds a few percent.
    CHECK(box.min()[axis] < center[axis] - 40);
    CHECK(box.max()[axis] > center[axis] + 40);
    CHECK(box.min()[axis] > center[axis] - 40 - 5);
    CHECK(box.max()[axis] < center[axis] + 40 + 5);
  }
}

TEST_CASE("the box tightly bounds the space that projects into all rectangles") {
  const Vec3 center(5, 6, 7);
  const std::vector<View> views = views_of_ball(ring_of_eyes(7, 500, 25), center, 30);
  const Box box = silhouette_box(views);
  std::vector<Rectangle> rectangles;
  for (const View& view : views) rectangles.push_back(rectangle_of(view.silhouette));

  // Points of a fine grid that project into all rectangles.
  Box reached{Vec3::Constant(1e9), Vec3::Constant(-1e9)};
  constexpr int steps = 60;
  for (int i = 0; i < steps * steps * steps; ++i) {
    const Vec3 share(i % steps, i / steps % steps, i / steps / steps);
    const Vec3 point = center + 50 * (2.0 / (steps - 1) * share - Vec3::Ones());
    bool is_in_all = true;
    for (std::size_t v = 0; v < views.size(); ++v)
      is_in_all = is_in_all && rectangles[v].contains(projected(views[v], point));
    if (!is_in_all) continue;
    reached.min() = reached.min().cwiseMin(point);
    reached.max() = reached.max().cwiseMax(point);
  }
  CHECK((reached.min() - box.min()).minCoeff() >= -1e-9);
  CHECK((box.max() - reached.max()).minCoeff() >= -1e-9);
  CHECK((reached.min() - box.min()).maxCoeff() < 4);  // the grid's step is 1.7
  CHECK((box.max() - reached.max()).maxCoeff() < 4);
}

TEST_CASE("unbounded objects are refused") {
  const std::vector<Vec3> front = {{600, 0, 0}};
  CHECK_THROWS_WITH_AS(silhouette_box(views_of_ball(front, Vec3::Zero(), 40)),
                       doctest::Contains("give its box"), InputError);

  // A silhouette that reaches the border of its image does not bound the object on this side.
  std::vector<View> views =
      views_of_ball({{600, 0, 0}, {0, 600, 0}, {0, 0, 600}}, Vec3::Zero(), 40);
  views[0] = ball_view({600, 0, 0}, Vec3::Zero(), 20);
  const Box whole = silhouette_box(views);
  for (int y = 115; y < 125; ++y)
    for (int x = 0; x < 160; ++x) views[0].silhouette.at(x, y) = 255;
  const Box open = silhouette_box(views);
  // The image of the first eye has y to its right.
  CHECK(whole.min().y() == doctest::Approx(-21).epsilon(0.1));
  CHECK(open.min().y() == doctest::Approx(-41).epsilon(0.1));
  CHECK(open.max().y() == doctest::Approx(whole.max().y()).epsilon(0.01));
  views.pop_back();
  CHECK_THROWS_AS(silhouette_box(views), InputError);
}

TEST_CASE("empty silhouettes and cameras that do not agree are refused") {
  std::vector<View> views = views_of_ball({{600, 0, 0}, {0, 600, 0}}, Vec3::Zero(), 40);
  views[1].silhouette = GrayImage(320, 240);
  views[1].name = "dark";
  CHECK_THROWS_WITH_AS(silhouette_box(views), doctest::Contains("'dark'"), InputError);

  views = views_of_ball({{600, 0, 0}, {0, 600, 0}}, Vec3::Zero(), 20);
  views[1] = ball_view({0, 600, 0}, {0, 0, 80}, 20);
  CHECK_THROWS_WITH_AS(silhouette_box(views), doctest::Contains("no point"), InputError);
}
