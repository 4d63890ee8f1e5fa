#include "reconstruction/better_parts.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

namespace {

/// Sums of one window at each vertex: `right` for x > 0, and `left` elsewhere.
std::vector<WindowSums> halves(const Mesh& mesh, double left, double right) {
  std::vector<WindowSums> sums;
  for (const Vec3& p : mesh.positions) sums.push_back({1, p.x() > 0 ? right : left, 0});
  return sums;
}

}  // namespace

TEST_CASE("the start comes back where photographs agree on it, with a smooth transition") {
  const Mesh start = test::icosphere(5);
  Mesh result = test::scaled(test::icosphere(4), 1.02);
  const double share =
      restore_better_parts(result, halves(result, 0.1, 0.3), {start, halves(start, 0.3, 0.1)}, 0.1);
  CHECK(share > 0.4);
  CHECK(share < 0.6);
  for (const Vec3& p : result.positions) {
    if (p.x() > 0.5) CHECK(p.norm() == doctest::Approx(1).epsilon(0.002));
    if (p.x() < -0.5) CHECK(p.norm() == doctest::Approx(1.02));
    CHECK(p.norm() < 1.0201);
    CHECK(p.norm() > 0.998);
  }
}

TEST_CASE("the result stays where it is clearly better, unobserved, or far from the start") {
  const Mesh start = test::icosphere(4);
  const Mesh result = test::scaled(test::icosphere(4), 1.02);
  const auto restored = [&](double of_result, double of_start, double reach) {
    Mesh mesh = result;
    return restore_better_parts(mesh, halves(mesh, of_result, of_result),
                                {start, halves(start, of_start, of_start)}, reach);
  };
  CHECK(restored(0.079, 0.1, 0.1) == 0);
  CHECK(restored(0.081, 0.1, 0.1) == 1);
  CHECK(restored(0.2, 0.1, 0.01) == 0);
  Mesh mesh = result;
  const std::vector<WindowSums> unseen(mesh.positions.size());
  CHECK(restore_better_parts(mesh, unseen, {start, unseen}, 0.1) == 0);
}
