#include "picture/corner_normals.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "helpers/shapes.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("normals of a fine sphere point away from its center") {
  const Mesh ball = icosphere(4);
  const std::vector<CornerNormals> normals = corner_normals(ball, 40);
  for (std::size_t f = 0; f < ball.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 normal = normals[f][i].cast<double>();
      CHECK((normal - ball.positions[ball.faces[f][i]]).norm() < 0.01);
    }
}

TEST_CASE("corners of a cube are creases up to a right angle") {
  const Mesh box = cube();
  const std::vector<CornerNormals> sharp = corner_normals(box, 89);
  const std::vector<CornerNormals> smooth = corner_normals(box, 91);
  for (std::size_t f = 0; f < box.faces.size(); ++f) {
    const Vec3 flat = face_normal(box, static_cast<Index>(f)).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK((sharp[f][i].cast<double>() - flat).norm() < 1e-6);
      // Weights by angle make normals independent of the diagonals of the sides.
      const Vec3 outward = 2 * box.positions[box.faces[f][i]] - Vec3::Ones();
      CHECK((smooth[f][i].cast<double>() - outward.normalized()).norm() < 1e-6);
    }
  }
}

TEST_CASE("a crease that ends within the surface parts normals only where it parts the faces") {
  // A square pyramid with four faces at its apex: one chain around it joins all.
  Mesh roof;
  roof.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0.1}};
  roof.faces = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const std::vector<CornerNormals> normals = corner_normals(roof, 20);
  for (std::size_t f = 0; f < 4; ++f)
    CHECK((normals[f][2] - Eigen::Vector3f::UnitZ()).norm() < 1e-6F);
  CHECK((corner_normals(roof, 1)[0][2] - Eigen::Vector3f::UnitZ()).norm() > 0.05F);
}

TEST_CASE("faces without area and without neighbors have no normal, and nothing breaks") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.faces = {{0, 1, 2}, {0, 0, 1}};
  for (const CornerNormals& corners : corner_normals(mesh, 40))
    for (const Eigen::Vector3f& normal : corners) CHECK(normal.isZero());
  CHECK(corner_normals(Mesh{}, 40).empty());
}
