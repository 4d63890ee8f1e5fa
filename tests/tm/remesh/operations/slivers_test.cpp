#include "tm/remesh/operations/slivers.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/cgal_oracle.h"
#include "helpers/shapes.h"
#include "tm/remesh/remesh_checks.h"

namespace transformesh::test {
namespace {

/// A square of two triangles whose diagonal has a vertex beside its middle: a cap of that height on
/// the first triangle.
Mesh square_with_cap(double height) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5 + height, 0.5 - height, 0}};
  mesh.faces = {{0, 4, 2}, {0, 1, 4}, {1, 2, 4}, {0, 2, 3}};
  Column material{"material", Scalar::int32};
  material.values = {7, 1, 1, 2};
  mesh.face_columns.columns.push_back(material);
  return mesh;
}

std::size_t count_kept(const EditableMesh& mesh) { return count_slivers(mesh).kept; }

}  // namespace

TEST_CASE("a cap is flipped away, and both faces get the properties of the face across") {
  EditableMesh mesh(square_with_cap(1e-16));
  REQUIRE(count_kept(mesh) == 1);
  CHECK(remove_slivers(mesh, VertexRoles(mesh, false)) == 1);
  CHECK(count_kept(mesh) == 0);
  const Mesh result = mesh.to_mesh();
  CHECK(is_oriented_manifold(result));
  CHECK(count_self_intersections(result) == 0);
  const auto& values = result.face_columns.columns[0].values;
  CHECK(std::count(values.begin(), values.end(), 2) == 2);
  CHECK(std::count(values.begin(), values.end(), 7) == 0);
}

TEST_CASE("a thin face of more than four spacings stays as it is") {
  EditableMesh mesh(square_with_cap(1e-12));
  CHECK(count_kept(mesh) == 0);
  CHECK(remove_slivers(mesh, VertexRoles(mesh, false)) == 0);
}

TEST_CASE("a needle loses its short edge") {
  // A sphere one of whose vertices is doubled, a spacing apart.
  Mesh sphere = icosphere(2);
  EditableMesh mesh(sphere);
  const Index halfedge = mesh.outgoing(20);
  const Vec3 at = mesh.position(20);
  mesh.split(halfedge, {std::nextafter(at.x(), 2), at.y(), at.z()});
  REQUIRE(count_kept(mesh) == 2);
  CHECK(remove_slivers(mesh, VertexRoles(mesh, false)) > 0);
  CHECK(count_kept(mesh) == 0);
  const Mesh result = mesh.to_mesh();
  CHECK(is_closed(result));
  CHECK(is_oriented_manifold(result));
  CHECK(count_self_intersections(result) == 0);
  CHECK(result.faces.size() == sphere.faces.size());
}

TEST_CASE("faces whose corners lie exactly on one line are removed") {
  EditableMesh mesh(square_with_cap(0));
  REQUIRE(count_slivers(mesh).without_area == 1);
  remove_slivers(mesh, VertexRoles(mesh, false));
  CHECK(count_slivers(mesh).without_area == 0);
}

}  // namespace transformesh::test
