#include "views/photo/contour_gaps.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "helpers/shapes.h"
#include "transformesh/hull.h"
#include "views/cameras/view.h"
#include "views/hull/contour_distance.h"

using namespace transformesh;
using doctest::Approx;

namespace {

constexpr double focal = 500;
constexpr double distance = 10;

/// Looks along z at the origin; pixels are 0.02 wide there.
View view_of_disk(double radius, double shift = 0) {
  View view;
  view.camera.intrinsics << focal, 0, 79.5 + shift, 0, focal, 59.5, 0, 0, 1;
  view.camera.translation = {0, 0, distance};
  view.image = view.silhouette = GrayImage(160, 120);
  // Edges are soft, so that the contour is a circle to a few hundredths of a pixel.
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const double inside = radius - std::hypot(x - 79.5 - shift, y - 59.5);
      view.silhouette.at(x, y) = static_cast<float>(255 * std::clamp(inside + 0.5, 0.0, 1.0));
    }
  }
  return view;
}

ContourGaps gaps_of(const Mesh& mesh, const std::vector<View>& views,
                    SilhouetteMeaning meaning = SilhouetteMeaning::exact) {
  std::vector<PackableImage> distances;
  for (const View& view : views)
    distances.push_back(view.silhouette.empty() ? GrayImage() : signed_distance(view.silhouette));
  return contour_gaps(mesh, views, SeenViews(mesh, views, 0.1), distances, meaning);
}

/// Returns the distance in pixels of a point from the middle of the image of the first view.
double pixels_from_middle(const Vec3& p) {
  return focal * std::hypot(p.x(), p.y()) / (p.z() + distance);
}

}  // namespace

TEST_CASE("distances outside of a disk are those from its circle") {
  const Mesh ball = test::icosphere(4);
  const ContourGaps gaps = gaps_of(ball, {view_of_disk(40)});
  std::size_t outside = 0;
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    const Vec3& p = ball.positions[v];
    const double pixels = pixels_from_middle(p) - 40;
    const double expected = std::max(pixels, 0.0) * (p.z() + distance) / focal;
    CHECK(std::abs(gaps.outside[v] - expected) < 0.1 * (p.z() + distance) / focal);
    CHECK(gaps.rims[v] == 0);
    outside += pixels > 1;
  }
  CHECK(outside > 100);
}

TEST_CASE("the rim has the distance to the contour beyond it, in every view with a contour") {
  // The ball's outline has a radius of 50.25 pixels.
  const Mesh ball = test::icosphere(4);
  const std::vector<View> views{view_of_disk(55), view_of_disk(55), View(view_of_disk(55))};
  std::vector<View> two = views;
  two[2].silhouette = GrayImage();
  const ContourGaps gaps = gaps_of(ball, two);
  std::size_t rims = 0;
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    CHECK(gaps.outside[v] == 0);
    if (gaps.rims[v] == 0) continue;
    ++rims;
    CHECK(gaps.rims[v] == 2);
    CHECK(pixels_from_middle(ball.positions[v]) > 48.5);
    const double expected = 55 - pixels_from_middle(ball.positions[v]);
    CHECK(gaps.inside[v] / 2 * focal / (ball.positions[v].z() + distance) ==
          Approx(expected).epsilon(0.05));
  }
  CHECK(rims > 30);
}

TEST_CASE("a rim before another part of the surface does not count") {
  // A wall that is larger than the image, behind the ball.
  Mesh mesh = test::icosphere(3);
  const Index first = static_cast<Index>(mesh.positions.size());
  for (const Vec3& corner : {Vec3(-9, -9, 3), Vec3(9, -9, 3), Vec3(9, 9, 3), Vec3(-9, 9, 3)})
    mesh.positions.push_back(corner);
  mesh.faces.push_back({first, first + 2, first + 1});
  mesh.faces.push_back({first, first + 3, first + 2});
  const ContourGaps gaps = gaps_of(mesh, {view_of_disk(55)});
  for (std::size_t v = 0; v < first; ++v) CHECK(gaps.rims[v] == 0);
}

TEST_CASE("outside of the image no distance is known") {
  // The right border cuts the disk, so vertices of the ball there are neither outside nor inside.
  const Mesh ball = test::icosphere(4);
  const ContourGaps gaps = gaps_of(ball, {view_of_disk(40, 60)});
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    const Vec3& p = ball.positions[v];
    if (focal * p.x() / (p.z() + distance) > 21) CHECK(gaps.outside[v] == 0);
  }
}

TEST_CASE("partial silhouettes pull outwards beyond a pixel, and never inwards") {
  const Mesh ball = test::icosphere(4);
  const auto least = SilhouetteMeaning::least;
  const ContourGaps inner = gaps_of(ball, {view_of_disk(40)}, least);
  CHECK(*std::max_element(inner.outside.begin(), inner.outside.end()) == 0);
  CHECK(*std::max_element(inner.rims.begin(), inner.rims.end()) == 0);

  const ContourGaps exact = gaps_of(ball, {view_of_disk(55)});
  const ContourGaps outer = gaps_of(ball, {view_of_disk(55)}, least);
  CHECK(*std::max_element(outer.rims.begin(), outer.rims.end()) == 1);
  for (std::size_t v = 0; v < ball.positions.size(); ++v) {
    CHECK(outer.rims[v] == exact.rims[v]);
    const double pixel = (ball.positions[v].z() + distance) / focal;
    CHECK(outer.inside[v] == Approx(exact.inside[v] - (exact.rims[v] > 0 ? pixel : 0)));
  }
}
