#include "views/depth/semiglobal_matching.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace transformesh;

namespace {

using Path = std::vector<std::vector<float>>;  ///< costs of the pixels

MatchingCosts random_costs(int columns, int rows, int planes, unsigned seed) {
  MatchingCosts costs{columns, rows, planes};
  std::mt19937 random(seed);
  for (int i = 0; i < columns * rows * planes; ++i)
    costs.values.push_back(static_cast<float>(random() % 1000) / 1000);
  return costs;
}

/// Returns the least cost of all sequences of planes that end with this plane, by trying all.
float least_by_trying(const Path& path, std::size_t last, std::size_t plane,
                      const SemiglobalOptions& options) {
  const float here = path[last][plane];
  if (last == 0) return here;
  float least = HUGE_VALF;
  for (std::size_t before = 0; before < path[last].size(); ++before) {
    const std::size_t jump = before > plane ? before - plane : plane - before;
    const float step = jump == 0 ? 0 : jump == 1 ? options.near_step : options.far_step;
    least = std::min(least, least_by_trying(path, last - 1, before, options) + step);
  }
  return here + least;
}

/// Sums over the paths to a pixel that begin at the border, or after a pixel without data.
std::vector<float> sums_by_trying(const MatchingCosts& costs, int x, int y,
                                  const SemiglobalOptions& options) {
  std::vector<float> sums(static_cast<std::size_t>(costs.planes), 0);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      Path path;
      for (int i = x, j = y; i >= 0 && j >= 0 && i < costs.columns && j < costs.rows;
           i -= dx, j -= dy) {
        const auto at = costs.at(i, j);
        if (std::all_of(at.begin(), at.end(), [](float cost) { return cost == 1; })) break;
        path.insert(path.begin(), {at.begin(), at.end()});
      }
      for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] += least_by_trying(path, path.size() - 1, k, options);
    }
  }
  return sums;
}

void check_as_by_trying(const MatchingCosts& costs, const SemiglobalOptions& options, int x,
                        int y) {
  const MatchingCosts result = semiglobal_costs(costs, options);
  const auto sums = result.at(x, y);
  std::vector<float> expected = sums_by_trying(costs, x, y, options);
  const float less = *std::min_element(sums.begin(), sums.end());
  const float least = *std::min_element(expected.begin(), expected.end());
  for (std::size_t k = 0; k < expected.size(); ++k)
    CHECK(sums[k] - less == doctest::Approx(expected[k] - least).epsilon(1e-4));
}

}  // namespace

TEST_CASE("summed costs are minimal over all choices of planes along all paths") {
  const SemiglobalOptions options{0.07F, 0.4F};
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const MatchingCosts costs = random_costs(5, 4, 3, seed);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 5; ++x) check_as_by_trying(costs, options, x, y);
  }
}

TEST_CASE("paths end at an invalid pixel, which gets no costs") {
  MatchingCosts costs = random_costs(5, 3, 3, 7);
  for (float& cost : costs.at(2, 1)) cost = 1;
  for (const int x : {0, 1, 3, 4}) check_as_by_trying(costs, {0.07F, 0.4F}, x, 1);
  const MatchingCosts sums = semiglobal_costs(costs);
  for (const float sum : sums.at(2, 1)) CHECK(sum == 0);
}

TEST_CASE("ambiguous pixels are decided by their neighbors") {
  MatchingCosts costs{9, 9, 6};
  for (int i = 0; i < 81; ++i)
    for (const float cost : {0.9F, 0.9F, 0.1F, 0.9F, 0.9F, 0.9F}) costs.values.push_back(cost);
  const auto middle = costs.at(4, 4);
  std::copy_n(std::vector<float>{0.5F, 0.5F, 0.5F, 0.5F, 0.5F, 0.4F}.begin(), 6, middle.begin());
  const MatchingCosts sums = semiglobal_costs(costs);
  const auto at = sums.at(4, 4);
  CHECK(std::min_element(at.begin(), at.end()) - at.begin() == 2);
}

TEST_CASE("an empty image has no costs") {
  CHECK(semiglobal_costs({}).values.empty());
  MatchingCosts one{1, 1, 1, {0.5F}};
  CHECK(semiglobal_costs(one).values == std::vector<float>{4.0F});
}
