#include "views/color/best_view_colors.h"

#include <doctest/doctest.h>

using namespace transformesh;

namespace {

const std::vector<Gain> no_gains(10, Gain::Ones());

float red_of(const BestViewColors& colors, const std::vector<Gain>& gains = no_gains) {
  return colors.blend(gains)[0];
}

}  // namespace

TEST_CASE("a point without views has no color, and a single view gives its color") {
  BestViewColors colors;
  CHECK(!colors.is_seen());
  colors.add({0, {1, 2, 3}}, 0);
  CHECK(!colors.is_seen());
  colors.add({.5, {10, 20, 30}}, 3);
  CHECK(colors.is_seen());
  CHECK(colors.view(0) == 3);
  CHECK((colors.blend(no_gains) - Eigen::Array3f(10, 20, 30)).abs().maxCoeff() < 1e-3F);
}

TEST_CASE("the best view decides where it is clearly better, and equal ones are averaged") {
  BestViewColors clear, equal;
  clear.add({1, {100, 0, 0}}, 0);
  clear.add({.3, {200, 0, 0}}, 1);
  CHECK(red_of(clear) == doctest::Approx(100).epsilon(.001));
  CHECK(clear.count_good() == 1);
  equal.add({1, {100, 0, 0}}, 0);
  equal.add({1, {200, 0, 0}}, 1);
  CHECK(red_of(equal) == doctest::Approx(150).epsilon(.001));
  CHECK(equal.count_good() == 2);
}

TEST_CASE("of three equally good views, one that disagrees has little weight") {
  BestViewColors colors;
  colors.add({1, {100, 0, 0}}, 0);
  colors.add({1, {102, 0, 0}}, 1);
  colors.add({1, {255, 0, 0}}, 2);
  CHECK(red_of(colors) < 110);
}

TEST_CASE("gains multiply the intensities of their views") {
  BestViewColors colors;
  colors.add({1, {100, 50, 10}}, 2);
  std::vector<Gain> gains = no_gains;
  gains[2] = Gain(.5F, 1, 2);
  CHECK((colors.blend(gains) - Eigen::Array3f(50, 50, 20)).abs().maxCoeff() < 1e-3F);
  CHECK(colors.difference(Eigen::Array3f(50, 50, 20), gains) < 1e-3F);
}

TEST_CASE("four views are kept, the best of all, and ties by order") {
  BestViewColors colors;
  for (std::size_t view = 0; view < 8; ++view)
    colors.add({view < 4 ? .5F : 1.F, {static_cast<std::uint8_t>(view), 0, 0}}, view);
  for (std::size_t i = 0; i < 4; ++i) CHECK(colors.view(i) == 4 + i);
}
