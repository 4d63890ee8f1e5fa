#include "reconstruction/place_loops.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "reconstruction/surface_doubt.h"

using namespace transformesh;

namespace {

/// True if the vertices for which `is_marked` is true contain a handle. They must be connected.
template <class Marks>
bool has_handle(const Mesh& mesh, const Marks& is_marked) {
  std::vector<bool> marks;
  for (const Vec3& position : mesh.positions) marks.push_back(is_marked(position));
  const auto first = std::find(marks.begin(), marks.end(), true) - marks.begin();
  const std::vector<Index> vertices =
      take_connected(static_cast<Index>(first), UniformLaplacian(mesh), marks);
  CHECK(std::find(marks.begin(), marks.end(), true) == marks.end());
  return PlaceLoops(mesh).has_handle(vertices);
}

}  // namespace

TEST_CASE("bands around the tube and along the tube of a torus have a handle, a patch has none") {
  const Mesh mesh = test::torus(1, 0.4, 60, 30);
  CHECK(has_handle(mesh, [](const Vec3& p) { return p.x() > 0 && std::abs(p.y()) < 0.2; }));
  CHECK(has_handle(mesh, [](const Vec3& p) { return p.z() > 0.2; }));
  CHECK(has_handle(mesh, [](const Vec3&) { return true; }));
  CHECK_FALSE(has_handle(mesh, [](const Vec3& p) { return p.x() > 0.5 && p.z() > 0; }));
}

TEST_CASE("a band around a ball, and a band with a border, have no handle") {
  const Mesh ball = test::icosphere(4);
  CHECK_FALSE(has_handle(ball, [](const Vec3& p) { return std::abs(p.z()) < 0.2; }));
  Mesh open = test::torus(1, 0.4, 60, 30);
  open.faces.pop_back();
  CHECK_FALSE(has_handle(open, [](const Vec3&) { return true; }));
}
