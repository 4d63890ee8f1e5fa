#include "transformesh/manifold.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"

using namespace transformesh;

namespace {

Mesh triangles(std::size_t vertices, std::vector<Face> faces) {
  Mesh mesh;
  for (std::size_t v = 0; v < vertices; ++v) {
    const double x = static_cast<double>(v);
    mesh.positions.emplace_back(x, x * x, x * x * x);
  }
  mesh.faces = std::move(faces);
  return mesh;
}

}  // namespace

TEST_CASE("closed shapes pass every check") {
  for (const Mesh& mesh :
       {test::tetrahedron(), test::cube(), test::icosphere(2), test::torus(2, 1, 8, 6)}) {
    const ManifoldReport report = check_manifold(mesh);
    CHECK(report.is_manifold());
    CHECK(report.is_oriented());
    CHECK(report.is_closed());
    CHECK(report.boundary_loops == 0);
    CHECK(manifold_problem(mesh, report, true).sentence.empty());
  }
}

TEST_CASE("a border is fine unless the mesh has to be closed") {
  const Mesh mesh = test::grid(3);
  const ManifoldReport report = check_manifold(mesh);
  CHECK(report.is_manifold());
  CHECK(report.border_halfedges.size() == 12);
  CHECK(report.boundary_loops == 1);
  CHECK(manifold_problem(mesh, report, false).sentence.empty());
  CHECK(manifold_problem(mesh, report, true).sentence.find("only one face (the first of 12") !=
        std::string::npos);
}

TEST_CASE("three faces on an edge are found with its vertices") {
  const Mesh mesh = triangles(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const ManifoldReport report = check_manifold(mesh);
  CHECK(report.nonmanifold_edges == std::vector<Index>{0});
  CHECK(report.nonmanifold_vertices == std::vector<Index>{0, 1});
  CHECK(report.misoriented_edges.empty());
  CHECK(manifold_problem(mesh, report, false).sentence ==
        "the edge from vertex 0 at (0, 0, 0) to vertex 1 at (1, 1, 1) of face 0 has more than two "
        "faces");
}

TEST_CASE("two cones that meet in their tips share a singular vertex") {
  const Mesh mesh = triangles(5, {{0, 1, 2}, {0, 3, 4}});
  const ManifoldReport report = check_manifold(mesh);
  CHECK(report.nonmanifold_edges.empty());
  CHECK(report.nonmanifold_vertices == std::vector<Index>{0});
  CHECK(report.boundary_loops == 2);
  CHECK(manifold_problem(mesh, report, false).sentence ==
        "the faces around vertex 0 at (0, 0, 0) do not form one umbrella");
}

TEST_CASE("misoriented faces affect the orientation only") {
  const Mesh mesh = triangles(4, {{0, 1, 2}, {0, 1, 3}});
  const ManifoldReport report = check_manifold(mesh);
  CHECK(report.is_manifold());
  CHECK(report.misoriented_edges == std::vector<Index>{0});
  CHECK(report.border_halfedges.size() == 4);
  CHECK(report.boundary_loops == 1);
  CHECK(!manifold_problem(mesh, report, false).sentence.empty());

  // The Moebius strip is a non-orientable manifold with one border.
  const Mesh strip = triangles(5, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
  const ManifoldReport moebius = check_manifold(strip);
  CHECK(moebius.is_manifold());
  CHECK_FALSE(moebius.is_oriented());
  CHECK(moebius.boundary_loops == 1);
}

TEST_CASE("faces that name a vertex twice spoil the manifold, equal positions do not") {
  Mesh mesh = test::tetrahedron();
  mesh.positions[3] = mesh.positions[2];
  CHECK(check_manifold(mesh).is_manifold());

  mesh = test::tetrahedron();
  mesh.faces.push_back({1, 1, 1});
  const ManifoldReport report = check_manifold(mesh);
  CHECK(report.collapsed_faces == std::vector<Index>{4});
  CHECK_FALSE(report.is_manifold());
  CHECK(manifold_problem(mesh, report, false).sentence == "face 4 uses a vertex twice");
}

TEST_CASE("isolated vertices are listed and affect nothing else") {
  Mesh mesh = test::cube();
  mesh.positions.emplace_back(7, 7, 7);
  const ManifoldReport report = check_manifold(mesh);
  CHECK(report.isolated_vertices == std::vector<Index>{8});
  CHECK(manifold_problem(mesh, report, true).sentence.empty());
  CHECK(check_manifold(Mesh{}).is_manifold());
}

TEST_CASE("two faces back to back form a sphere") {
  const ManifoldReport report = check_manifold(triangles(3, {{0, 1, 2}, {0, 2, 1}}));
  CHECK(report.is_manifold());
  CHECK(report.is_oriented());
  CHECK(report.is_closed());
}
