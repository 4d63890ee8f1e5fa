#include "remesh/operations/slivers.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/cgal_oracle.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// A square of two triangles with a vertex near the middle of its diagonal, moved by `height` along
/// x and y. The first triangle is a cap.
Mesh square_with_cap(double height) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5 + height, 0.5 - height, 0}};
  mesh.faces = {{0, 4, 2}, {0, 1, 4}, {1, 2, 4}, {0, 2, 3}};
  Column material;
  material.name = "material";
  material.type = Scalar::int32;
  material.values = {7, 1, 1, 2};
  mesh.face_columns.columns.push_back(material);
  return mesh;
}

/// A shortest edge that is so short that only coordinate spacings decide whether a face is a
/// sliver.
constexpr double any_edge = 1e-12;

Slivers slivers_of(const EditableMesh& mesh, double shortest = any_edge) {
  return count_slivers(mesh, SliverTest(mesh, shortest));
}

void remove(EditableMesh& mesh, double shortest = any_edge) {
  remove_slivers(mesh, VertexRoles(mesh, false), SliverTest(mesh, shortest));
}

}  // namespace

TEST_CASE("a cap is flipped away, and both faces get the properties of the face across") {
  EditableMesh mesh(square_with_cap(1e-16));
  REQUIRE(slivers_of(mesh).kept == 1);
  remove(mesh);
  CHECK(slivers_of(mesh).kept == 0);
  const Mesh result = mesh.to_mesh();
  CHECK(is_oriented_manifold(result));
  CHECK(count_self_intersections(result) == 0);
  const auto& values = result.face_columns.columns[0].values;
  CHECK(std::count(values.begin(), values.end(), 2) == 2);
  CHECK(std::count(values.begin(), values.end(), 7) == 0);
}

TEST_CASE("a thin face is a sliver if it is far thinner than edges are long") {
  EditableMesh mesh(square_with_cap(1e-7));
  CHECK(slivers_of(mesh, 1e-3).kept == 0);
  remove(mesh, 1e-3);
  CHECK(slivers_of(mesh, 1e-1).kept == 1);
  remove(mesh, 1e-1);
  CHECK(slivers_of(mesh, 1e-1).kept == 0);
}

TEST_CASE("a needle loses its short edge") {
  // A sphere with one vertex doubled, a spacing apart.
  Mesh sphere = icosphere(2);
  EditableMesh mesh(sphere);
  const Index halfedge = mesh.outgoing(20);
  const Vec3 at = mesh.position(20);
  mesh.split(halfedge, {std::nextafter(at.x(), 2), at.y(), at.z()});
  REQUIRE(slivers_of(mesh).kept == 2);
  remove(mesh);
  CHECK(slivers_of(mesh).kept == 0);
  const Mesh result = mesh.to_mesh();
  CHECK(is_closed(result));
  CHECK(is_oriented_manifold(result));
  CHECK(count_self_intersections(result) == 0);
  CHECK(result.faces.size() == sphere.faces.size());
}

TEST_CASE("faces whose corners lie exactly on one line are removed") {
  EditableMesh mesh(square_with_cap(0));
  REQUIRE(slivers_of(mesh).without_area == 1);
  remove(mesh);
  CHECK(slivers_of(mesh).without_area == 0);
}
