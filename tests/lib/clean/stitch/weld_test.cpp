/// Merging and snapping of positions, compared with brute force over all pairs.
#include "clean/stitch/weld.h"

#include <doctest/doctest.h>

#include <numeric>

#include "helpers/random.h"

using namespace transformesh;

namespace {

/// Points in clusters, some of them equal.
std::vector<Vec3> clumps(std::uint64_t seed, double size) {
  test::Random random(seed);
  std::vector<Vec3> positions;
  while (positions.size() < 120) {
    const Vec3 middle = random.point(-1, 1);
    for (std::uint64_t i = random.below(6) + 1; i > 0; --i)
      positions.push_back(middle + random.point(-size, size));
    if (random.below(3) == 0) positions.push_back(positions[random.below(positions.size())]);
  }
  return positions;
}

/// Returns the smallest index that can be reached by steps of at most the tolerance.
std::vector<Index> welded_by_steps(const std::vector<Vec3>& positions, double tolerance) {
  std::vector<Index> root(positions.size());
  std::iota(root.begin(), root.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (Index i = 0; i < positions.size(); ++i) {
      for (Index k = 0; k < positions.size(); ++k) {
        if ((positions[i] - positions[k]).norm() > tolerance || root[k] >= root[i]) continue;
        root[i] = root[k];
        changed = true;
      }
    }
  }
  return root;
}

}  // namespace

TEST_CASE("positions are welded transitively over short distances") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const std::vector<Vec3> positions = clumps(seed, 0.05);
    for (const double tolerance : {0.0, 0.02, 0.05, 0.2, 5.0}) {
      CAPTURE(tolerance);
      CHECK(weld_positions(positions, tolerance) == welded_by_steps(positions, tolerance));
    }
  }
  CHECK(weld_positions({{0, 0, 0}, {-0.0, 0, -0.0}}, 0) == std::vector<Index>{0, 0});
  CHECK(weld_positions({}, 1).empty());
}

TEST_CASE("clusters of points within the tolerance are welded as the definition says") {
  for (const double tolerance : {0.01, 0.05, 0.1, 0.25}) {
    test::Random random(static_cast<std::uint64_t>(1000 * tolerance));
    std::vector<Vec3> plate;  // flat: all x differ by less than 1e-3
    std::vector<Vec3> heaps;  // three heaps about the tolerance apart
    std::vector<Vec3> lattice;
    for (int i = 0; i < 700; ++i) {
      plate.push_back(random.point(0, 1).cwiseProduct(Vec3(1e-3, 1, 1)));
      const double heap = static_cast<double>(random.below(3));
      heaps.push_back(Vec3(heap * 1.02 * tolerance, 0, 0) + random.point(0, 0.02 * tolerance));
      lattice.push_back(0.05 * Vec3(0, static_cast<double>(random.below(40)),
                                    static_cast<double>(random.below(40))));
    }
    for (const auto& positions : {plate, heaps, lattice})
      CHECK(weld_positions(positions, tolerance) == welded_by_steps(positions, tolerance));
  }
}
