#include "mesh/surface_columns.h"

#include <doctest/doctest.h>

#include <array>

#include "helpers/shapes.h"
#include "step/prepare_target.h"
#include "transformesh/displace.h"
#include "transformesh/mesh_io.h"
#include "transformesh/remesh.h"
#include "transformesh/stitch.h"
#include "transformesh/target.h"

using namespace transformesh;

namespace {

// On a sphere around the origin the normal is the direction of the position.
double worst_normal(const Mesh& ball, double sign) {
  double worst = 0;
  const std::vector<Vec3> normals = stored_normals(ball);
  for (std::size_t v = 0; v < normals.size(); ++v)
    worst = std::max(worst, (normals[v] - sign * ball.positions[v].normalized()).norm());
  return worst;
}

Mesh ball_with_normals() {
  Mesh ball = test::icosphere(3);
  set_normal_columns(ball, std::vector<Vec3>(ball.positions.size(), Vec3::UnitX()));
  refresh_normals(ball);
  return ball;
}

// Texture coordinates x and y of the corners.
Column texture_of(const Mesh& mesh) {
  Column column{"texcoord", Scalar::float64, {}, Scalar::uint8, {0}};
  for (const Face& face : mesh.faces) {
    for (const Index v : face) {
      column.values.push_back(mesh.positions[v].x());
      column.values.push_back(mesh.positions[v].y());
    }
    column.list_offsets.push_back(column.values.size());
  }
  return column;
}

}  // namespace

TEST_CASE("new normals replace integers, and negative ones fit") {
  Mesh ball = ball_with_normals();
  for (Column& column : ball.vertex_columns.columns) column.type = Scalar::int8;
  refresh_normals(ball);
  for (const Column& column : ball.vertex_columns.columns) CHECK(column.type == Scalar::float64);
  CHECK(worst_normal(ball, 1) < 0.02);
  for (Column& column : ball.vertex_columns.columns) {
    column.type = Scalar::uint8;
    column.values.assign(column.values.size(), 100);
  }
  reverse_normals(ball);
  for (const Column& column : ball.vertex_columns.columns) {
    CHECK(column.type == Scalar::float64);
    CHECK(column.values[0] == -100);
  }
}

TEST_CASE("normals are updated if the surface is moved, rotated or remeshed") {
  Mesh ball = ball_with_normals();
  CHECK(worst_normal(ball, 1) < 0.02);

  // An ellipsoid that moves back to the ball.
  std::vector<Vec3> back;
  for (Vec3& p : ball.positions) {
    back.emplace_back(-p.x(), 0, 0);
    p.x() *= 2;
  }
  refresh_normals(ball);
  CHECK(worst_normal(ball, 1) > 0.2);
  CHECK(displace(ball, back, {1, 1e9}).new_normals);
  CHECK(worst_normal(ball, 1) < 0.02);

  RemeshOptions options;
  options.min_edge = 0.02;
  options.max_edge = 0.06;
  CHECK(remesh(ball, options).columns.new_normals);
  CHECK(worst_normal(ball, 1) < 0.06);
  stitch(ball, {.flip = true});
  CHECK(worst_normal(ball, -1) < 0.06);
}

TEST_CASE("texture coordinates of corners follow reversed and removed faces") {
  Mesh ball = test::icosphere(2);
  ball.face_columns.columns.push_back(texture_of(ball));
  stitch(ball, {.flip = true});
  CHECK(ball.face_columns.columns[0].values == texture_of(ball).values);
  std::swap(ball.faces[3][1], ball.faces[3][2]);
  reverse_corner_lists(ball, 3);
  CHECK(stitch(ball, {.orient = true}).reversed_faces > 0);
  CHECK(ball.face_columns.columns[0].values == texture_of(ball).values);

  RemeshOptions options;
  options.min_edge = 0.1;
  options.max_edge = 0.2;
  CHECK(remesh(ball, options).columns.dropped == std::vector<std::string>{"texcoord"});
  CHECK(ball.face_columns.columns.empty());
}

TEST_CASE("triangles of a polygon have the texture coordinates of their own corners") {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nelement face 2\nproperty list uchar int vertex_indices\n"
      "property list uchar float texcoord\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n"
      "4 0 1 2 3 8 0 0 1 0 1 1 0 1\n3 0 1 4 6 0 0 1 0 0 0\n";
  const Mesh mesh = read_mesh(text, "a.ply").document.mesh;
  REQUIRE(mesh.faces.size() == 3);
  const Column& column = mesh.face_columns.columns.at(0);
  CHECK(column.list_offsets == std::vector<std::size_t>{0, 6, 12, 18});
  CHECK(column.values == texture_of(mesh).values);
}
