#include "remesh/operations/edge_collapser.h"

#include <algorithm>
#include <cmath>

#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// A mesh in which single edges can be collapsed if no edge becomes longer than `max_edge`.
struct Scene {
  EditableMesh mesh;
  EmbeddingGuard guard;
  VertexRoles roles;
  EdgeCollapser collapser;

  explicit Scene(const Mesh& input, double max_edge = 10, double feature_angle_deg = 180)
      : mesh(marked(input, feature_angle_deg)),
        guard(mesh, max_edge),
        roles(mesh, false),
        collapser(mesh, guard, roles, max_edge) {}

  static EditableMesh marked(const Mesh& input, double feature_angle_deg) {
    EditableMesh mesh(input);
    mark_features(mesh, feature_angle_deg);
    return mesh;
  }
  Index halfedge(Index source, Index target) const {
    for (Index h = 0; h < mesh.halfedge_slots(); ++h)
      if (mesh.has_halfedge(h) && mesh.source(h) == source && mesh.target(h) == target) return h;
    return no_index;
  }
};

/// Returns the index of vertex (i, j) of the grid of n x n cells.
Index vertex_of_grid(Index n, Index i, Index j) { return i * (n + 1) + j; }

}  // namespace

TEST_CASE("an edge becomes its lower vertex, whichever way it is named") {
  for (const bool is_reversed : {false, true}) {
    Scene scene(icosphere(2));
    Index h = 100;
    if (is_reversed) h = scene.mesh.opposite(h);
    const auto [low, high] = std::minmax({scene.mesh.source(h), scene.mesh.target(h)});
    CHECK(scene.collapser.collapse(h) == low);
    CHECK(scene.mesh.has_vertex(low));
    CHECK_FALSE(scene.mesh.has_vertex(high));
    const Mesh mesh = scene.mesh.to_mesh();
    CHECK(mesh.faces.size() == icosphere(2).faces.size() - 2);
    CHECK(is_oriented_manifold(mesh));
    CHECK(is_closed(mesh));
  }
}

TEST_CASE("the merged vertex leaves the plane of the edge so that the volume stays to rounding") {
  const Mesh sphere = icosphere(3);
  for (const Index h : {Index{0}, Index{301}, Index{999}}) {
    Scene scene(sphere);
    const Vec3 middle = 0.5 * (scene.mesh.position(scene.mesh.source(h)) +
                               scene.mesh.position(scene.mesh.target(h)));
    const Index vertex = scene.collapser.collapse(h);
    REQUIRE(vertex != no_index);
    CHECK(volume(scene.mesh.to_mesh()) == doctest::Approx(volume(sphere)).epsilon(1e-14));
    CHECK(scene.mesh.position(vertex).norm() > middle.norm());
  }
}

TEST_CASE("in a plane the merged vertex is the midpoint") {
  Scene scene(grid(6));
  const Index from = vertex_of_grid(6, 2, 3);
  const Index to = vertex_of_grid(6, 3, 3);
  const Vec3 middle = 0.5 * (scene.mesh.position(from) + scene.mesh.position(to));
  const Index vertex = scene.collapser.collapse(scene.halfedge(from, to));
  REQUIRE(vertex == from);
  CHECK((scene.mesh.position(vertex) - middle).norm() < 1e-15);
}

TEST_CASE("a vertex of a border and a corner keep their places") {
  Scene scene(grid(6));
  const Index inside = vertex_of_grid(6, 1, 3);
  const Index border = vertex_of_grid(6, 0, 3);
  const Vec3 place = scene.mesh.position(border);
  const Index vertex = scene.collapser.collapse(scene.halfedge(inside, border));
  REQUIRE(vertex != no_index);
  CHECK(scene.mesh.position(vertex) == place);

  Scene corner(grid(6));
  const Index next = vertex_of_grid(6, 0, 1);
  const Index merged = corner.collapser.collapse(
      corner.halfedge(next, 0) != no_index ? corner.halfedge(next, 0) : corner.halfedge(0, next));
  REQUIRE(merged != no_index);
  CHECK(corner.mesh.position(merged) == Vec3(0, 0, 0));
}

TEST_CASE("corners of a box with sharp edges do not merge") {
  Scene scene(cube(), 10, 40);
  for (Index h = 0; h < scene.mesh.halfedge_slots(); ++h)
    CHECK(scene.collapser.collapse(h) == no_index);
  CHECK(is_same(scene.mesh.to_mesh(), cube()));
}

TEST_CASE("a collapse that would make too long an edge is refused") {
  const Mesh mesh = grid(6);
  const Index from = vertex_of_grid(6, 2, 3);
  const Index to = vertex_of_grid(6, 3, 3);
  // Neighbors of the merged vertex are half a cell off in one direction and a cell in the other, or
  // farther. The longest new edge leads to the corner (1.5, 1) cells away.
  const double longest = std::hypot(1.5, 1) / 6;
  Scene tight(mesh, 0.99 * longest);
  CHECK(tight.collapser.collapse(tight.halfedge(from, to)) == no_index);
  Scene loose(mesh, 1.01 * longest);
  CHECK(loose.collapser.collapse(loose.halfedge(from, to)) == from);
}

TEST_CASE("between two shells too close on either side no edge collapses") {
  const Mesh middle = icosphere(2);
  const Mesh shells = joined(joined(middle, scaled(middle, 1.001)), scaled(middle, 0.999));
  for (Index h = 0; h < 3 * middle.faces.size(); h += 7) {
    CAPTURE(h);
    CHECK(Scene(middle).collapser.collapse(h) != no_index);
    CHECK(Scene(shells).collapser.collapse(h) == no_index);
  }
}
