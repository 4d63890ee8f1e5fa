#include "mesh/touching_borders.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

/// Counts coincident border edges by comparing all pairs of border edges.
std::size_t count_by_search(const Mesh& mesh) {
  const auto halfedges = static_cast<Index>(3 * mesh.faces.size());
  const auto is_border = [&](Index h) {
    for (Index o = 0; o < halfedges; ++o) {
      const Index a = halfedge_source(mesh, o), b = halfedge_target(mesh, o);
      const Index s = halfedge_source(mesh, h), t = halfedge_target(mesh, h);
      if (o != h && ((a == s && b == t) || (a == t && b == s))) return false;
    }
    return halfedge_source(mesh, h) != halfedge_target(mesh, h);
  };
  const auto place = [&](Index v) -> const Vec3& { return mesh.positions[v]; };
  std::size_t count = 0;
  for (Index h = 0; h < halfedges; ++h) {
    const Vec3& from = place(halfedge_source(mesh, h));
    const Vec3& to = place(halfedge_target(mesh, h));
    if (!is_border(h) || from == to) continue;
    for (Index o = 0; o < halfedges; ++o) {
      if (place(halfedge_source(mesh, o)) != to || place(halfedge_target(mesh, o)) != from)
        continue;
      if (!is_border(o)) continue;
      ++count;
      break;
    }
  }
  return count;
}

/// A mesh in which some corners have vertices of their own, and some faces are missing.
Mesh partly_apart(const Mesh& mesh, unsigned seed) {
  test::Random random(seed);
  Mesh result;
  result.positions = mesh.positions;
  for (Face face : mesh.faces) {
    if (random.uniform(0, 1) < 0.1) continue;
    for (Index& v : face) {
      if (random.uniform(0, 1) < 0.8) continue;
      result.positions.push_back(mesh.positions[v]);
      v = static_cast<Index>(result.positions.size() - 1);
    }
    result.faces.push_back(face);
  }
  return result;
}

}  // namespace

TEST_CASE("closed and open meshes have no borders that touch, and a soup has nothing else") {
  CHECK(count_touching_borders(test::cube()) == 0);
  Mesh open = test::icosphere(2);
  open.faces.resize(100);
  CHECK(count_touching_borders(open) == 0);
  CHECK_NOTHROW(refuse_touching_borders(open));
  const Mesh soup = test::soup_of(test::cube());
  CHECK(count_touching_borders(soup) == 36);
  CHECK_THROWS_AS(refuse_touching_borders(soup), InputError);
}

TEST_CASE("borders that touch are those of a search, in meshes that are partly apart") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh mesh = partly_apart(test::icosphere(1), seed);
    CAPTURE(seed);
    CHECK(count_touching_borders(mesh) == count_by_search(mesh));
  }
}

TEST_CASE("borders that run the same way, or lie in one place, do not touch") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  CHECK(count_touching_borders(mesh) == 0);
  mesh.faces[1] = {4, 3, 5};
  CHECK(count_touching_borders(mesh) == 2);
  mesh.positions[0] = {-0.0, 0, 0};
  CHECK(count_touching_borders(mesh) == 2);
}
