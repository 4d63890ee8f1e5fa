/// Affine maps, compared with closed forms.
#include "transformesh/transform.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "helpers/shapes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

Mesh with_vectors(Mesh mesh, const std::array<const char*, 3>& names,
                  const std::vector<Vec3>& vectors) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    Column& column = mesh.vertex_columns.get(names[static_cast<std::size_t>(i)], Scalar::float64,
                                             mesh.positions.size());
    for (std::size_t v = 0; v < vectors.size(); ++v) column.values[v] = vectors[v][i];
  }
  return mesh;
}

Vec3 vector_at(const Mesh& mesh, const std::array<const char*, 3>& names, std::size_t row) {
  return {mesh.vertex_columns.find(names[0])->values[row],
          mesh.vertex_columns.find(names[1])->values[row],
          mesh.vertex_columns.find(names[2])->values[row]};
}

}  // namespace

TEST_CASE("volumes grow by the determinant, and mirrors keep the outside") {
  Matrix4 matrix = Matrix4::Identity();
  matrix.topLeftCorner<3, 3>() << 1, 2, 0, 0.5, -1, 3, 2, 0, 1;  // determinant 10
  for (const double sign : {1.0, -1.0}) {
    matrix.row(0).head<3>() = sign * Eigen::RowVector3d(1, 2, 0);
    Mesh mesh = test::icosphere(2);
    const double before = volume(mesh);
    CHECK(transform(mesh, matrix).is_mirror == (sign < 0));
    CHECK(volume(mesh) == doctest::Approx(10 * before));
  }
}

TEST_CASE("normals stay normal and velocities move with the vertices") {
  const Mesh ball = test::icosphere(2);
  Mesh mesh = with_vectors(ball, {"nx", "ny", "nz"}, ball.positions);
  mesh = with_vectors(mesh, {"vx", "vy", "vz"}, ball.positions);
  const Matrix4 matrix = translation_by({5, 6, 7}) * scaling_by({-1, 2, 3});
  transform(mesh, matrix);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    // The gradient of the ellipsoid x^2 + y^2 / 4 + z^2 / 9 = 1.
    const Vec3 p = mesh.positions[v] - Vec3(5, 6, 7);
    const Vec3 gradient = Vec3(p.x(), p.y() / 4, p.z() / 9).normalized();
    CHECK((vector_at(mesh, {"nx", "ny", "nz"}, v) - gradient).norm() < 1e-14);
    CHECK((vector_at(mesh, {"vx", "vy", "vz"}, v) - p).norm() < 1e-14);
  }
}

TEST_CASE("normals and velocities of integers turn as vectors of real numbers") {
  const std::vector<Vec3> along(4, Vec3(0, 0, 127));
  Mesh mesh = with_vectors(test::tetrahedron(), {"nx", "ny", "nz"}, along);
  mesh = with_vectors(mesh, {"vx", "vy", "vz"}, along);
  for (Column& column : mesh.vertex_columns.columns) column.type = Scalar::int8;
  transform(mesh, rotation_about({1, 0, 0}, 30));
  const Vec3 turned(0, -0.5, std::sqrt(0.75));
  CHECK((vector_at(mesh, {"nx", "ny", "nz"}, 3) - turned).norm() < 1e-15);
  CHECK((vector_at(mesh, {"vx", "vy", "vz"}, 3) - 127 * turned).norm() < 1e-13);
  for (const Column& column : mesh.vertex_columns.columns) CHECK(column.type == Scalar::float64);
}

TEST_CASE("quarter turns are exact, and others turn by their angle") {
  Mesh mesh = test::cube();
  transform(mesh, rotation_about({0, 0, 2}, 90 + 36000));
  CHECK(mesh.positions[1] == Vec3(0, 1, 0));
  CHECK(mesh.positions[2] == Vec3(-1, 0, 0));
  const Vec3 third = (rotation_about({1, 1, 1}, 120) * Eigen::Vector4d(1, 0, 0, 1)).head<3>();
  CHECK((third - Vec3(0, 1, 0)).norm() < 1e-15);
  const Vec3 turned = (rotation_about({0, 0, 1}, -30) * Eigen::Vector4d(1, 0, 0, 1)).head<3>();
  CHECK((turned - Vec3(std::sqrt(0.75), -0.5, 0)).norm() < 1e-15);
}

TEST_CASE("mirrors, boxes and scales") {
  const Eigen::Vector4d point(1, 2, 3, 1);
  CHECK((mirroring_in({0, 0, 2}, 8) * point).head<3>() == Vec3(1, 2, 5));
  Mesh mesh = test::cuboid({-1, 2, 3}, {3, 4, 4});
  Mesh copy = mesh;
  transform(mesh, fitting_unit_box(mapped_box(mesh, Matrix4::Identity())));
  CHECK(bounding_box(mesh).min() == Vec3(0, 0.25, 0.375));
  CHECK(bounding_box(mesh).max() == Vec3(1, 0.75, 0.625));
  transform(copy, centering(mapped_box(copy, Matrix4::Identity())));
  CHECK(bounding_box(copy).min() == Vec3(-2, -1, -0.5));
  CHECK(scale_of(scaling_by({-3, 3, 3})) == 3);
  CHECK(scale_of(rotation_about({1, 2, 3}, 40)) == 1);
}

TEST_CASE("singular, projective and infinite matrices are refused") {
  Mesh mesh = test::cube();
  const auto before = mesh.positions;
  Matrix4 matrix = scaling_by({1, 1, 0});
  CHECK_THROWS_AS(transform(mesh, matrix), UsageError);
  matrix.topLeftCorner<3, 3>() << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  CHECK_THROWS_AS(transform(mesh, matrix), UsageError);
  matrix = Matrix4::Identity();
  matrix(3, 0) = 1;
  CHECK_THROWS_AS(transform(mesh, matrix), UsageError);
  matrix = translation_by({std::numeric_limits<double>::infinity(), 0, 0});
  CHECK_THROWS_AS(transform(mesh, matrix), UsageError);
  CHECK_THROWS_AS(rotation_about(Vec3::Zero(), 3), UsageError);
  CHECK_THROWS_AS(fitting_unit_box(Box()), InputError);
  transform(mesh, scaling_by(Vec3::Constant(1e200)));
  const auto large = mesh.positions;
  CHECK_THROWS_AS(transform(mesh, scaling_by(Vec3::Constant(1e200))), GoalError);
  CHECK(mesh.positions == large);
  // This matrix makes the mesh flat, but it is not singular.
  transform(mesh, scaling_by({1e-200, 1e-200, 1e-250}));
  CHECK((mesh.positions[7].head<2>() - before[7].head<2>()).norm() < 1e-15);
}
