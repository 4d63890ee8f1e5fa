/// Meshes with T-junctions, compared with the meshes without them.
#include "clean/stitch/split_border_edges.h"

#include <doctest/doctest.h>

#include "helpers/mesh_facts.h"
#include "helpers/shapes.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

TEST_CASE("a triangle is cut at vertices upon all of its edges, and keeps its area") {
  // Smaller triangles beyond each edge of the first triangle have further vertices on these edges.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0},  {2, 0, 0}, {4, 0, 0},
                    {5, 3, 0}, {0, 6, 0}, {3, -3, 0}, {7, 7, 0}, {-3, 3, 0}};
  mesh.faces = {{0, 1, 2}, {0, 7, 3}, {3, 7, 4}, {4, 7, 1},
                {1, 8, 5}, {5, 8, 2}, {2, 9, 6}, {6, 9, 0}};
  const double area = surface_area(mesh);
  const BorderSplits splits = split_border_edges(mesh, 1e-12);
  CHECK(splits.edges == 3);
  CHECK(splits.face_source == std::vector<Index>{0, 0, 0, 0});
  CHECK(mesh.faces.size() == 12);
  CHECK(surface_area(mesh) == doctest::Approx(area));
  const ManifoldReport found = check_manifold(mesh);
  CHECK(found.is_manifold());
  CHECK(found.is_oriented());
  CHECK(found.border_halfedges.size() == 6);
}

TEST_CASE("vertices beyond the tolerance, and closed meshes, split nothing") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5 + 1e-6, 0}};
  mesh.faces = {{0, 1, 2}, {0, 4, 3}, {4, 2, 3}};
  CHECK(split_border_edges(mesh, 1e-7).edges == 0);
  CHECK(split_border_edges(mesh, 1e-5).edges == 1);
  Mesh cube = test::cube();
  CHECK(split_border_edges(cube, 1e-3).edges == 0);
}
