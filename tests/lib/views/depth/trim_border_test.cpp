#include "views/depth/trim_border.h"

#include <doctest/doctest.h>

#include "mesh/edges.h"
#include "mesh/umbrellas.h"

using namespace transformesh;

namespace {

/// Returns the squares of a grid for which `is_in(x, y)`, each as two triangles.
template <typename Inside>
Mesh squares(Index side, const Inside& is_in) {
  Mesh mesh;
  for (Index y = 0; y <= side; ++y)
    for (Index x = 0; x <= side; ++x)
      mesh.positions.emplace_back(static_cast<double>(x), static_cast<double>(y), 0);
  for (Index y = 0; y < side; ++y)
    for (Index x = 0; x < side; ++x) {
      if (!is_in(x, y)) continue;
      const Index a = y * (side + 1) + x;
      mesh.faces.push_back({a, a + 1, a + side + 2});
      mesh.faces.push_back({a, a + side + 2, a + side + 1});
    }
  return mesh;
}

}  // namespace

TEST_CASE("a strip beside a square is removed, and the square stays") {
  Mesh mesh = squares(40, [](Index x, Index y) { return x < 20 || (y >= 9 && y < 12); });
  trim_border(mesh, 3);
  double longest = 0;
  for (const Vec3& position : mesh.positions) longest = std::max(longest, position.x());
  CHECK(longest >= 20);
  CHECK(longest <= 23);
  CHECK(mesh.faces.size() >= 2 * 20 * 40 - 40);
  CHECK(mesh.faces.size() <= 2 * 20 * 40 + 2 * 3 * 3);
}

TEST_CASE("a wide strip stays, and nothing changes without a border to trim") {
  const auto is_wide = [](Index x, Index y) { return x < 20 || (y >= 9 && y < 23); };
  Mesh mesh = squares(40, is_wide);
  const std::size_t faces = mesh.faces.size();
  trim_border(mesh, 3);
  CHECK(mesh.faces.size() > faces - 60);
  Mesh tetrahedron{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                   {},
                   {}};
  trim_border(tetrahedron, 3);
  CHECK(tetrahedron.faces.size() == 4);
}

TEST_CASE("two squares that touch in a vertex are parted there") {
  Mesh mesh = squares(20, [](Index x, Index y) { return (x < 10) == (y < 10); });
  CHECK(find_umbrellas(mesh, Edges(mesh)).vertex_of.size() == mesh.positions.size() - 200 + 1);
  trim_border(mesh, 0);
  CHECK(find_umbrellas(mesh, Edges(mesh)).vertex_of.size() == mesh.positions.size());
  CHECK(mesh.faces.size() >= 2 * 200 - 8);
}
