#include "transformesh/align_features.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/compare.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// A target with edges of about `edge`, whose sharp edges are cut off by smoothing, as after a
/// morph.
Mesh rounded(Mesh mesh, double edge) {
  RemeshOptions options;
  options.min_edge = 0.7 * edge;
  options.max_edge = 1.5 * edge;
  options.iterations = 2;
  options.feature_angle_deg = 40;
  remesh(mesh, options);
  options.feature_angle_deg = 180;
  options.smoothing = Smoothing::laplace;
  options.smooth_first = 0.1;
  options.iterations = 4;
  remesh(mesh, options);
  return mesh;
}

AlignOptions edges_around(double length) {
  AlignOptions options;
  options.min_edge = 0.7 * length;
  options.max_edge = 1.5 * length;
  return options;
}

bool has_vertex_at(const Mesh& mesh, const Vec3& point) {
  return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                     [&](const Vec3& p) { return (p - point).norm() < 1e-12; });
}

double distance_from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

/// Returns the largest distance of points along a segment from the edges of the mesh, by brute
/// force.
double distance_from_edges(const Mesh& mesh, const Vec3& from, const Vec3& to) {
  double farthest = 0;
  for (int i = 0; i <= 20; ++i) {
    const Vec3 point = from + i / 20.0 * (to - from);
    double nearest = HUGE_VAL;
    for (Index h = 0; h < 3 * mesh.faces.size(); ++h)
      nearest =
          std::min(nearest, distance_from_segment(point, mesh.positions[halfedge_source(mesh, h)],
                                                  mesh.positions[halfedge_target(mesh, h)]));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

void check_is_sound(const Mesh& mesh, double least_angle) {
  CHECK(test::count(mesh).is_closed_and_oriented);
  CHECK(find_intersections(mesh).empty());
  CHECK(angles(mesh).minimum_deg > least_angle);
}

/// A prism over a regular polygon with `n` corners, with radius and height 1.
Mesh prism(Index n) {
  Mesh mesh;
  for (const double z : {0.0, 1.0})
    for (Index i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  mesh.positions.emplace_back(0, 0, 0);
  mesh.positions.emplace_back(0, 0, 1);
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.faces.push_back({i, j, n + j});
    mesh.faces.push_back({i, n + j, n + i});
    mesh.faces.push_back({2 * n, j, i});
    mesh.faces.push_back({2 * n + 1, n + i, n + j});
  }
  return mesh;
}

}  // namespace

TEST_CASE("a rounded cube becomes the cube: corners, edges and volume") {
  const Mesh cube = test::cube();
  Mesh mesh = rounded(cube, 0.1);
  REQUIRE(volume(mesh) < 0.995);
  const AlignResult result = align_features(mesh, cube, edges_around(0.1));
  CHECK(result.sharp_edges == 12);
  CHECK(result.corners == 8);
  CHECK(result.aligned > 90);
  check_is_sound(mesh, 15);
  CHECK(volume(mesh) == Approx(1).epsilon(1e-10));
  CHECK(surface_area(mesh) == Approx(6).epsilon(1e-10));
  for (const Vec3& corner : cube.positions) CHECK(has_vertex_at(mesh, corner));
  for (int axis = 0; axis < 3; ++axis)
    for (int other = 0; other < 4; ++other) {
      Vec3 from(0, 0, 0);
      from[(axis + 1) % 3] = other % 2;
      from[(axis + 2) % 3] = other / 2;
      Vec3 to = from;
      to[axis] = 1;
      CHECK(distance_from_edges(mesh, from, to) < 1e-12);
    }
}

TEST_CASE("concave edges are aligned as well") {
  const Mesh block = test::cuboid(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const Mesh other = test::cuboid(Vec3(0.4, 0.3, 0.35), Vec3(1.6, 0.7, 1.5));
  const Mesh target = clean(test::joined(block, other)).mesh;
  Mesh mesh = rounded(target, 0.08);
  const double before = compare(mesh, target).hausdorff;
  align_features(mesh, target, edges_around(0.08));
  check_is_sound(mesh, 10);
  const Comparison after = compare(mesh, target);
  CHECK(before > 0.04);
  CHECK(after.hausdorff < 0.02);
  CHECK(volume(mesh) == Approx(volume(target)).epsilon(1e-3));
}

TEST_CASE("curved edges are followed, and smooth parts beside them stay smooth") {
  const Mesh target = prism(90);
  Mesh mesh = rounded(target, 0.1);
  const double before = compare(mesh, target).hausdorff;
  const AlignResult result = align_features(mesh, target, edges_around(0.1));
  CHECK(result.corners == 0);
  check_is_sound(mesh, 15);
  CHECK(before > 0.03);
  CHECK(compare(mesh, target).hausdorff < 0.01);
  // Edges between vertices on the rims cover both circles.
  double length = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (Index i = 0; i < 3; ++i) {
      const Vec3& a = mesh.positions[mesh.faces[f][i]];
      const Vec3& b = mesh.positions[mesh.faces[f][(i + 1) % 3]];
      const auto is_on_rim = [](const Vec3& p) {
        return (p.z() == 0 || p.z() == 1) && p.head<2>().norm() > 0.999;
      };
      if (is_on_rim(a) && is_on_rim(b)) length += 0.5 * (a - b).norm();
    }
  CHECK(length == Approx(4 * std::numbers::pi).epsilon(0.005));
}

TEST_CASE("attributes are carried along") {
  Mesh mesh = rounded(test::cube(), 0.1);
  Column& column = mesh.vertex_columns.get("h", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    column.values[v] = mesh.positions[v].dot(Vec3(1, 2, 3));
  align_features(mesh, test::cube(), edges_around(0.1));
  const std::vector<double>& values = mesh.vertex_columns.find("h")->values;
  REQUIRE(values.size() == mesh.positions.size());
  for (std::size_t v = 0; v < values.size(); ++v)
    CHECK(std::abs(values[v] - mesh.positions[v].dot(Vec3(1, 2, 3))) < 0.4);
}

TEST_CASE("without sharp edges nothing changes; which targets have some") {
  Mesh mesh = test::scaled(test::icosphere(2), 1.01);
  const Mesh before = mesh;
  CHECK(align_features(mesh, test::icosphere(3), edges_around(0.3)).sharp_edges == 0);
  CHECK(mesh.positions == before.positions);
  CHECK(mesh.faces == before.faces);
  CHECK(has_features(test::cube()));
  CHECK(has_features(prism(40)));
  CHECK(!has_features(test::icosphere(1)));
  CHECK(!has_features(test::torus(1, 0.4, 20, 10)));
  Mesh noisy = test::icosphere(4);
  test::Random random(3);
  for (Vec3& p : noisy.positions) p += random.point(-0.01, 0.01);
  CHECK(!has_features(noisy));
  CHECK_THROWS_AS(
      align_features(mesh, test::cube(), {.feature_angle_deg = 0, .min_edge = 1, .max_edge = 2}),
      UsageError);
  Mesh empty;
  CHECK_THROWS_AS(align_features(empty, test::cube(), edges_around(1)), InputError);
}
