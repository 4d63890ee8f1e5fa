#include "tm/views/hull/silhouette.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tm/support/error.h"

using namespace transformesh;

namespace {

constexpr int width = 64;
constexpr int height = 48;

/// An image whose levels are those of a function of the place, positive outside, cut off.
template <typename Function>
GrayImage soft_mask(const Function& distance) {
  GrayImage mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      mask.at(x, y) = std::clamp(127.5F - 80 * static_cast<float>(distance(x, y)), 0.0F, 255.0F);
  return mask;
}

double disc(double x, double y) { return std::hypot(x - 30.3, y - 22.6) - 11.7; }
/// Inside is left of a slanted line that crosses the whole image.
double half_plane(double x, double y) { return 0.8 * (x - 20.4) + 0.6 * (y - 10.2); }

template <typename Function>
double worst_error(const GrayImage& distances, const Function& exact) {
  double worst = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      worst = std::max(worst, std::abs(distances.at(x, y) - exact(x, y)));
  return worst;
}

}  // namespace

TEST_CASE("a soft disc: the distance is that to the circle") {
  CHECK(worst_error(signed_distance(soft_mask(disc)), disc) < 0.05);
}

TEST_CASE("a disc of two levels: within half a pixel") {
  const GrayImage distances = signed_distance(two_levels(soft_mask(disc)));
  const double worst = worst_error(distances, disc);
  CHECK(worst < 0.5);
  CHECK(worst > 0.05);  // the stairs are there
}

TEST_CASE("a straight contour, as far as it stays in the image") {
  // Beyond its ends the nearest point of the line is outside the image: the distance is larger.
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

TEST_CASE("every distance is that of the nearest crossing, found by looking at all") {
  // Two discs, a frame and a thin line, so that contours compete.
  GrayImage mask(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (std::hypot(x - 15, y - 15) < 9 || std::hypot(x - 44, y - 30) < 7 || y == 40 ||
          (x > 55 && x < 60 && y > 3 && y < 9))
        mask.at(x, y) = 255;
  const GrayImage distances = signed_distance(mask);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Crossings of the grid lines: the contour joins neighbours, at most 1 apart.
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

TEST_CASE("a threshold finds the contour between pixels") {
  // A bright disc with an edge as soft as a camera's: it crosses level 60 at a radius that is
  // known.
  GrayImage photograph(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      photograph.at(x, y) = static_cast<float>(std::clamp(60 - 30 * disc(x, y), 0.0, 200.0));
  const GrayImage distances = signed_distance(threshold_silhouette(photograph, {60, 0, 0}));
  CHECK(worst_error(distances, disc) < 0.1);
  const GrayImage lower = signed_distance(threshold_silhouette(photograph, {30, 0, 0}));
  CHECK(worst_error(lower, [](double x, double y) { return disc(x, y) - 1; }) < 0.1);
}

TEST_CASE("blur forgets single bright pixels") {
  GrayImage photograph = soft_mask(disc);
  photograph.at(60, 5) = 255;
  CHECK(threshold_silhouette(photograph, {100, 0, 0}).at(60, 5) > 127.5F);
  CHECK(threshold_silhouette(photograph, {100, 1.5, 0}).at(60, 5) < 127.5F);
  CHECK(inside_share(photograph) ==
        doctest::Approx(3.14159 * 11.7 * 11.7 / (width * height)).epsilon(0.02));
}

TEST_CASE("without a level, that between dark and bright pixels is found") {
  // Levels around 40 and around 180, both with some spread.
  GrayImage photograph(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      photograph.at(x, y) = static_cast<float>((disc(x, y) < 0 ? 180 : 40) + (7 * x + 3 * y) % 31);
  const GrayImage mask = two_levels(threshold_silhouette(photograph, {std::nullopt, 0, 0}));
  CHECK(mask.pixels == two_levels(soft_mask(disc)).pixels);
}

TEST_CASE("dark marks on the object become part of it, wide gaps do not") {
  // A wide bar that leaves the image, with a dark line, a notch and a wide hole in it.
  GrayImage photograph(width, height);
  const auto fill = [&](int left, int top, int right, int bottom, float level) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) photograph.at(x, y) = level;
  };
  fill(0, 5, 50, 43, 200);
  const GrayImage unmarked = photograph;
  fill(10, 12, 40, 14, 0);
  fill(5, 20, 20, 35, 0);
  const GrayImage closed = two_levels(threshold_silhouette(photograph, {100, 0, 0.05}));  // 3.2
  CHECK(closed.at(20, 12) == 255);
  CHECK(closed.at(12, 27) == 0);
  // What is outside stays outside, also where the bar leaves the image.
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (unmarked.at(x, y) == 0) CHECK(closed.at(x, y) == 0);
  for (int y = 5; y < 11; ++y) CHECK(closed.at(0, y) == 255);
}

TEST_CASE("options that make no sense are refused") {
  const GrayImage image(4, 4);
  CHECK_THROWS_AS(threshold_silhouette(image, {0, 1, 0}), UsageError);
  CHECK_THROWS_AS(threshold_silhouette(image, {255, 1, 0}), UsageError);
  CHECK_THROWS_AS(threshold_silhouette(image, {25, -1, 0}), UsageError);
  CHECK_THROWS_AS(threshold_silhouette(image, {25, 1, -0.1}), UsageError);
  CHECK(signed_distance(GrayImage()).empty());
  CHECK(threshold_silhouette(GrayImage()).empty());
}

TEST_CASE("agreement is intersection over union") {
  GrayImage left(10, 10);
  GrayImage right(10, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 6; ++x) left.at(x, y) = 255;
    for (int x = 4; x < 10; ++x) right.at(x, y) = 255;
  }
  CHECK(silhouette_agreement(left, right) == doctest::Approx(0.2));
  CHECK(silhouette_agreement(left, left) == 1);
  CHECK(silhouette_agreement(GrayImage(3, 3), GrayImage(3, 3)) == 1);
  CHECK_THROWS_AS(silhouette_agreement(left, GrayImage(10, 9)), UsageError);
}
