#include "views/hull/contour_distance.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/disc_mask.h"
#include "views/hull/silhouette.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Inside is left of a slanted line that crosses the whole image.
double half_plane(double x, double y) { return 0.8 * (x - 20.4) + 0.6 * (y - 10.2); }

}  // namespace

TEST_CASE("a soft disc: the distance is that to the circle") {
  CHECK(worst_error(signed_distance(soft_mask(disc)), disc) < 0.05);
}

TEST_CASE("a disc of two intensities: within half a pixel") {
  const GrayImage distances = signed_distance(binary_silhouette(soft_mask(disc)));
  const double worst = worst_error(distances, disc);
  CHECK(worst < 0.5);
  CHECK(worst > 0.05);  // the contour is a staircase here
}

TEST_CASE("a straight contour, as far as it stays in the image") {
  // Beyond the ends of the contour, the nearest point of the line is outside of the image, so the
  // distance is larger.
  const GrayImage distances = signed_distance(soft_mask(half_plane));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double exact = half_plane(x, y);
      CHECK(std::abs(distances.at(x, y)) >= std::abs(exact) - 1e-4);
      const double foot_x = x - 0.8 * exact;
      const double foot_y = y - 0.6 * exact;
      if (foot_x < 0 || foot_y < 0 || foot_x > width - 1 || foot_y > height - 1) continue;
      CHECK(std::abs(distances.at(x, y) - exact) < 0.02);
    }
  }
}

TEST_CASE("every distance is that of the nearest contour point, by brute force") {
  // Two discs, a frame and a thin line, so that every pixel has several contours nearby.
  GrayImage mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (std::hypot(x - 15, y - 15) < 9 || std::hypot(x - 44, y - 30) < 7 || y == 40 ||
          (x > 55 && x < 60 && y > 3 && y < 9))
        mask.at(x, y) = 255;
  const GrayImage distances = signed_distance(mask);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Intersections with the grid lines; the contour connects neighbors, which are at most 1
      // apart.
      double nearest = 1e9;
      for (int v = 0; v < height; ++v)
        for (int u = 0; u < width; ++u) {
          if (u + 1 < width && mask.at(u, v) != mask.at(u + 1, v))
            nearest = std::min(nearest, std::hypot(u + 0.5 - x, v - y));
          if (v + 1 < height && mask.at(u, v) != mask.at(u, v + 1))
            nearest = std::min(nearest, std::hypot(u - x, v + 0.5 - y));
        }
      const double found = std::abs(distances.at(x, y));
      CHECK(found <= nearest + 0.05);
      CHECK(found >= std::sqrt(std::max(0.0, nearest * nearest - 0.25)) - 0.15);
      CHECK((distances.at(x, y) < 0) == (mask.at(x, y) > 0));
    }
  }
}

TEST_CASE("the border of the image is no contour") {
  GrayImage mask(width, height, 255);
  const GrayImage all = signed_distance(mask);
  CHECK(all.at(0, 0) == -std::numeric_limits<float>::infinity());
  CHECK(distance_at(all, 3.2, 4.1) == -std::numeric_limits<float>::infinity());

  for (int y = 0; y < height; ++y) mask.at(width - 1, y) = 0;
  CHECK(signed_distance(mask).at(0, 20) == doctest::Approx(-(width - 1.5)));
}

TEST_CASE("distances between pixels, and beyond them") {
  GrayImage distances(3, 2);
  distances.pixels = {0, 1, 2, 10, 11, 12};
  CHECK(distance_at(distances, 1.25, 0.5) == doctest::Approx(6.25));
  CHECK(distance_at(distances, 2, 1) == 12);
  CHECK(distance_at(distances, -0.4, 0) == 0);
  CHECK(distance_at(distances, 2.4, 1.4) == 12);
  CHECK(std::isnan(distance_at(distances, -0.6, 0)));
  CHECK(std::isnan(distance_at(distances, 1, 1.6)));
  CHECK(std::isnan(distance_at(distances, NAN, 0)));
}

TEST_CASE("a limit cuts off distances and changes none below it") {
  const GrayImage all = signed_distance(soft_mask(disc));
  const GrayImage near = signed_distance(soft_mask(disc), 6);
  for (std::size_t i = 0; i < all.pixels.size(); ++i) {
    if (std::abs(all.pixels[i]) < 4) CHECK(near.pixels[i] == all.pixels[i]);
    CHECK(std::abs(near.pixels[i]) <= 6);
  }
}
