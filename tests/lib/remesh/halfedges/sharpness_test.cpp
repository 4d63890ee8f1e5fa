#include "remesh/halfedges/sharpness.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"
#include "transformesh/shapes.h"

using namespace transformesh;

namespace {

/// A prism with n sides, or a pyramid.
Mesh prism(int sides, double height, bool ends_in_tip) {
  Mesh mesh;
  const auto n = static_cast<Index>(sides);
  for (const double z : {0.0, height})
    for (Index i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, radius = ends_in_tip && z > 0 ? 0 : 1;
      mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, height);
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n;
    mesh.faces.push_back({2 * n, next, i});
    if (ends_in_tip) {
      mesh.faces.push_back({i, next, 2 * n + 1});
      continue;
    }
    mesh.faces.insert(mesh.faces.end(), {{i, next, n + next}, {i, n + next, n + i}});
    mesh.faces.push_back({2 * n + 1, n + i, n + next});
  }
  if (!ends_in_tip) return mesh;
  mesh.positions.erase(mesh.positions.begin() + sides, mesh.positions.begin() + 2 * sides);
  for (Face& face : mesh.faces)
    for (Index& v : face) v = v < n ? v : v - n;
  return mesh;
}

Mesh shape(const std::string& kind, std::size_t faces, std::vector<std::string> parameters = {}) {
  ShapeOptions options;
  options.kind = kind;
  options.parameters = std::move(parameters);
  options.faces = faces;
  return make_shape(options);
}

/// Moves every vertex by up to `edges` mean edges along each axis.
Mesh noisy(Mesh mesh, double edges) {
  test::Random random(1);
  const double most = edges * edge_lengths(mesh).mean;
  for (Vec3& position : mesh.positions) position += random.point(-most, most);
  return mesh;
}

bool is_sharp(const Mesh& mesh) { return has_sharp_edges(EditableMesh(mesh)); }

/// Rotates a mesh, so that coordinates are rounded.
Mesh turned(Mesh mesh) {
  const Eigen::AngleAxisd turn(0.3, Vec3(1, 2, 3).normalized());
  for (Vec3& position : mesh.positions) position = turn * position;
  return mesh;
}

/// Splits every face at a point `height` inside of the middle of its first edge. The face at this
/// edge is too thin to have a normal.
Mesh with_slivers(Mesh mesh, double height) {
  const std::size_t faces = mesh.faces.size();
  for (std::size_t f = 0; f < faces; ++f) {
    const auto [a, b, c] = mesh.faces[f];
    const auto apex = static_cast<Index>(mesh.positions.size());
    const Vec3 middle = 0.5 * mesh.positions[a] + 0.5 * mesh.positions[b];
    mesh.positions.push_back(middle + height * (mesh.positions[c] - middle).normalized());
    mesh.faces[f] = {apex, b, c};
    mesh.faces.push_back({a, apex, c});
    mesh.faces.push_back({a, b, apex});
  }
  return mesh;
}

}  // namespace

TEST_CASE("bodies of flat and round faces have sharp edges, however fine their mesh") {
  CHECK(is_sharp(test::cube()));
  CHECK(is_sharp(test::tetrahedron()));
  for (const std::size_t faces : {100, 1000, 10000, 100000}) CHECK(is_sharp(shape("box", faces)));
  for (const int sides : {3, 6, 8, 9, 10, 11, 12, 24, 100}) {
    CAPTURE(sides);
    CHECK(is_sharp(prism(sides, 2, false)));
    CHECK(is_sharp(prism(sides, 1, true)));
  }
  CHECK(is_sharp(noisy(shape("box", 2000, {"1", "1", "3"}), 0.05)));
}

TEST_CASE("smooth shapes have no sharp edges, even if coarse, noisy or folded") {
  for (const int subdivisions : {0, 1, 2, 3}) CHECK_FALSE(is_sharp(test::icosphere(subdivisions)));
  for (const char* kind : {"dumbbell", "torus", "bowl", "folded"})
    for (const std::size_t faces : {500, 1000, 3000}) CHECK_FALSE(is_sharp(shape(kind, faces)));
  CHECK_FALSE(is_sharp(shape("torus", 200)));
  CHECK_FALSE(is_sharp(shape("genus", 500, {"3"})));
  for (const double noise : {0.1, 0.2, 0.3, 0.5, 1.0})
    CHECK_FALSE(is_sharp(noisy(test::icosphere(4), noise)));
}

TEST_CASE("a spike on a ball is no sharp edge") {
  Mesh ball = test::icosphere(4);
  ball.positions[0] *= 1.2;
  CHECK_FALSE(is_sharp(ball));
}

TEST_CASE("faces too thin to have a normal take that of the face beyond their longest edge") {
  for (const double height : {1e-15, 3e-16}) {
    const Mesh mesh = turned(with_slivers(test::cube(), height));
    CHECK(is_sharp(mesh));
    const std::vector<Vec3> normals = steady_normals(EditableMesh(mesh));
    // Every normal is along an axis of the rotated cube.
    const Eigen::AngleAxisd back(-0.3, Vec3(1, 2, 3).normalized());
    for (const Vec3& normal : normals)
      CHECK((back * normal).cwiseAbs().maxCoeff() == doctest::Approx(1));
  }
}

TEST_CASE("remeshing chooses sharp edges from the input, and reports the choice") {
  RemeshOptions options;
  options.min_edge = 0.1;
  options.max_edge = 0.2;
  options.feature_angle_deg = 0;
  Mesh box = test::cube();
  CHECK(remesh(box, options).feature_angle_deg == 40);
  Mesh ball = test::icosphere(3);
  CHECK(remesh(ball, options).feature_angle_deg == 180);
  options.feature_angle_deg = 70;
  CHECK(remesh(ball, options).feature_angle_deg == 70);
}
