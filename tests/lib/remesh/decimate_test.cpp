/// Numbers of faces that collapses alone do not reach: merging of flat faces, and messages.
#include "transformesh/decimate.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

/// A cube cut by planes across y that lie one rounding error apart, so that most faces are slivers
/// of that width.
Mesh cube_of_slivers(int slivers) {
  std::vector<double> heights{0};
  for (int i = 0; i < slivers; ++i) heights.push_back(0.5 + i * 0x1p-53);
  heights.push_back(1);
  const auto n = static_cast<Index>(heights.size());
  Mesh mesh;
  for (const double z : {0.0, 1.0})
    for (const double x : {0.0, 1.0})
      for (const double y : heights) mesh.positions.emplace_back(x, y, z);
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    mesh.faces.push_back({a, b, c});
    mesh.faces.push_back({a, c, d});
  };
  for (Index i = 0; i + 1 < n; ++i) {
    const Index low = i, right = n + i, top = 2 * n + i, corner = 3 * n + i;
    quad(top, corner, corner + 1, top + 1);
    quad(low, low + 1, right + 1, right);
    quad(right, right + 1, corner + 1, corner);
    quad(low, top, top + 1, low + 1);
  }
  quad(0, n, 3 * n, 2 * n);
  quad(n - 1, 3 * n - 1, 4 * n - 1, 2 * n - 1);
  return mesh;
}

}  // namespace

TEST_CASE("slivers as thin as rounding errors are merged where no edge of them can collapse") {
  Mesh mesh = cube_of_slivers(60);
  REQUIRE(test::is_closed(mesh));
  const std::size_t before = mesh.faces.size();
  const DecimateResult result = decimate(mesh, {20});
  CHECK(mesh.faces.size() == 12);
  CHECK(result.merged_faces == before - 12);
  CHECK(std::abs(volume(mesh) - 1) < 1e-15);
  Mesh kept = cube_of_slivers(60);
  DecimateOptions options{20};
  options.keep_border = true;
  CHECK_THROWS_AS(decimate(kept, options), GoalError);
}

TEST_CASE("a number of faces that cannot be reached is reported") {
  Mesh mesh = test::icosphere(2);
  CHECK_THROWS_AS(decimate(mesh, {3}), UsageError);
  Mesh empty;
  CHECK_THROWS_AS(decimate(empty, {10}), InputError);
  // Two balls need at least four faces each.
  Mesh pair = test::joined(mesh, test::moved(mesh, {3, 0, 0}));
  CHECK_THROWS_AS(decimate(pair, {4}), GoalError);
  CHECK(pair.faces.size() == 2 * mesh.faces.size());
  const std::size_t faces = mesh.faces.size();
  CHECK(decimate(mesh, {faces}).collapses == 0);
}
