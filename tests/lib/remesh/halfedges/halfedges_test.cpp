#include "remesh/halfedges/halfedges.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "mesh/adjacency.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

/// A bowl of very many faces around one vertex, in random order.
Mesh wheel(Index spokes) {
  Mesh mesh;
  mesh.positions.assign(spokes + 1, Vec3::Zero());
  for (Index i = 0; i < spokes; ++i) mesh.faces.push_back({0, i + 1, (i + 1) % spokes + 1});
  test::Random random(3);
  for (std::size_t i = mesh.faces.size(); i > 1; --i)
    std::swap(mesh.faces[i - 1], mesh.faces[random.below(i)]);
  return mesh;
}

}  // namespace

TEST_CASE(
    "opposites are those of a search by edges, also with borders and around a crowded vertex") {
  Mesh open = test::torus(1, 0.4, 30, 12);
  open.faces.resize(open.faces.size() - 37);
  for (const Mesh& mesh :
       {test::icosphere(3), test::torus(1, 0.4, 30, 12), open, wheel(5), wheel(20000)})
    CHECK(manifold_opposites(mesh) == opposite_halfedges(mesh));
}

TEST_CASE("misoriented faces, and third faces at an edge, are refused with their indices") {
  Mesh turned = test::icosphere(1);
  std::swap(turned.faces[7][0], turned.faces[7][1]);
  CHECK_THROWS_AS(manifold_opposites(turned), InputError);
  Mesh third = test::icosphere(1);
  third.positions.emplace_back(3, 0, 0);
  third.faces.push_back(
      {third.faces[5][0], third.faces[5][1], static_cast<Index>(third.positions.size() - 1)});
  CHECK_THROWS_WITH_AS(manifold_opposites(third),
                       doctest::Contains("faces 5 and 80 traverse the edge"), InputError);
}
