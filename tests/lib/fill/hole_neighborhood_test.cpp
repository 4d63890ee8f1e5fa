/// Blends of border vertices, compared with a sort of all vertices.
#include "fill/hole_neighborhood.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "helpers/random.h"

using namespace transformesh;

namespace {

/// Returns the three nearest vertices, of equally near ones those with lower indices.
std::array<Index, 3> nearest_by_sort(const Mesh& mesh, const std::vector<Index>& vertices,
                                     const Vec3& point) {
  std::vector<std::pair<double, Index>> all;
  for (const Index v : vertices) all.emplace_back((mesh.positions[v] - point).norm(), v);
  std::sort(all.begin(), all.end());
  return {all[0].second, all[1].second, all[2].second};
}

}  // namespace

TEST_CASE("a blend takes the three nearest vertices, also of a regular border") {
  for (const double scale : {1e-170, 1e-160, 1.0, 1e170}) {
    constexpr int count = 100;
    Mesh mesh;
    std::vector<Index> border;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      mesh.positions.emplace_back(scale * std::cos(angle), scale * std::sin(angle), 0);
      border.insert(border.begin(), static_cast<Index>(i));
    }
    const BorderBlend blend(mesh, border);
    test::Random random(3);
    for (int i = 0; i < 200; ++i) {
      // The center has nearly the same distance from all vertices.
      const Vec3 point = i == 0 ? Vec3::Zero() : Vec3(scale * random.point(-1, 1));
      const RowBlend row = blend(point);
      const bool is_exact = row.weight[1] == 0;
      const std::array<Index, 3> expected = nearest_by_sort(mesh, border, point);
      CHECK(row.source[0] == expected[0]);
      if (!is_exact) CHECK(row.source == expected);
    }
  }
}

TEST_CASE("a blend at a vertex is the row of this vertex, and weights sum to 1") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  const BorderBlend blend(mesh, {3, 2, 1, 0});
  const RowBlend at_vertex = blend(Vec3::Zero());
  CHECK(at_vertex.source[0] == 0);
  CHECK(at_vertex.weight == std::array<double, 3>{1, 0, 0});
  const RowBlend between = blend({0.25, 0.25, 0});
  CHECK(between.source == Face{0, 3, 1});
  CHECK(between.weight[0] + between.weight[1] + between.weight[2] == doctest::Approx(1));
}
