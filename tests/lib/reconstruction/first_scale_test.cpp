#include "reconstruction/first_scale.h"

#include <doctest/doctest.h>

#include <map>

using namespace transformesh;

namespace {

const std::vector<double> scales{4, 2.8284, 2, 1.4142, 1};

/// Sums of a hundred vertices, `wrong` of which disagree.
std::vector<WindowSums> sums_of(int wrong) {
  std::vector<WindowSums> sums(100, {2, 0.9, 0});
  for (int v = 0; v < wrong; ++v) sums[static_cast<std::size_t>(v)].energy = 1.1;
  return sums;
}

double chosen(const std::map<double, int>& wrong) {
  return first_scale(scales, [&](double scale) { return sums_of(wrong.at(scale)); });
}

}  // namespace

TEST_CASE("the finest scale at which nearly all windows are alike is the first one") {
  // Coarser scales are not measured.
  CHECK(chosen({{1, 3}}) == 1);
  CHECK(chosen({{2, 3}, {1.4142, 4}, {1, 30}}) == 2);
}

TEST_CASE("without such a scale, the coarsest of those with the least share is the first one") {
  CHECK(chosen({{4, 50}, {2.8284, 41}, {2, 40}, {1.4142, 45}, {1, 60}}) == 2.8284);
  CHECK(chosen({{4, 50}, {2.8284, 43}, {2, 40}, {1.4142, 40}, {1, 60}}) == 2);
  CHECK(chosen({{4, 40}, {2.8284, 40}, {2, 40}, {1.4142, 40}, {1, 40}}) == 4);
}

TEST_CASE("a start that no two views observe is refined from the coarsest scale") {
  CHECK(first_scale(scales, [](double) { return std::vector<WindowSums>(5); }) == 4);
}
