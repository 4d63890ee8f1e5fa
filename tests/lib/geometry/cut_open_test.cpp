#include <doctest/doctest.h>

#include <cmath>

#include "geometry/plane_distances.h"
#include "geometry/section_svg.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/select.h"

using namespace transformesh;
using doctest::Approx;

namespace {

double length_of(const std::vector<std::pair<Vec3, Vec3>>& segments) {
  double length = 0;
  for (const auto& [a, b] : segments) length += (b - a).norm();
  return length;
}

/// Returns the largest distance of the vertices behind the plane.
double overhang(const Mesh& mesh, const CutPlane& plane) {
  double most = 0;
  for (const Vec3& p : mesh.positions) most = std::max(most, plane.offset - plane.normal.dot(p));
  return most;
}

}  // namespace

TEST_CASE("an open cut and a capped one are the part in front of the plane") {
  const Vec3 normal = Vec3(1, 2, 3).normalized();
  for (const double offset : {-0.9, -0.2, 0.0, 0.5}) {
    const CutPlane plane{normal, offset};
    const Mesh ball = test::icosphere(3);
    Mesh open = ball, closed = ball;
    CHECK(cut_open(open, plane));
    cut_closed(closed, plane);
    CHECK(overhang(open, plane) < 1e-14);
    CHECK(overhang(closed, plane) < 1e-14);
    CHECK(check_manifold(closed).is_closed());
    // A cap closes the cut: the areas differ by a disk.
    const double height = 1 - offset;
    const double disk = M_PI * (1 - offset * offset);
    CHECK(surface_area(closed) - surface_area(open) == Approx(disk).epsilon(0.02));
    CHECK(volume(closed) == Approx(M_PI * height * height * (3 - height) / 3).epsilon(0.03));
    CHECK(length_of(plane_section(ball, plane)) ==
          Approx(2 * M_PI * std::sqrt(1 - offset * offset)).epsilon(0.01));
  }
}

TEST_CASE("columns are interpolated at new vertices, and lists of texture coordinates dropped") {
  Mesh mesh = test::cube();
  Column& height = mesh.vertex_columns.get("height", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) height.values[v] = mesh.positions[v].z();
  CHECK(cut_open(mesh, {{0, 0, 1}, 0.3}));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK(mesh.vertex_columns.find("height")->values[v] == Approx(mesh.positions[v].z()));
  CHECK(bounding_box(mesh).min().z() == 0.3);
  CHECK_FALSE(cut_open(mesh, {{0, 0, 1}, 0.3}));
}

TEST_CASE("planes through vertices, edges and faces") {
  Mesh cube = test::cube();
  CHECK_FALSE(cut_open(cube, {{0, 0, 1}, 0}));
  CHECK(cube.faces.size() == 12);
  CHECK_THROWS_AS(cut_open(cube, {{0, 0, 1}, 1}), GoalError);
  CHECK_THROWS_AS(cut_closed(cube, {{0, 0, 1}, 1}), GoalError);
  CHECK_THROWS_AS(cut_open(cube, {{0, 0, 0}, 1}), UsageError);
  CHECK_THROWS_AS(cut_closed(cube, {{0, 0, 0}, 1}), UsageError);
  for (const Vec3& normal : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(1, 1, 1)}) {
    Mesh half = cube;
    cut_closed(half, {normal, normal.sum() / 2});
    CHECK(check_manifold(half).is_closed());
    CHECK(volume(half) == Approx(0.5));
  }
}

TEST_CASE("a drawing has one closed path for each curve") {
  const Mesh ring = test::torus(2, 0.5, 40, 20);
  const CutPlane plane{{0, 0, 1}, 0.1};
  const std::string svg = section_svg(plane_section(ring, plane), plane.normal);
  std::size_t paths = 0, closed = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1))
    ++paths;
  for (std::size_t at = svg.find(" Z\""); at != std::string::npos; at = svg.find(" Z\"", at + 1))
    ++closed;
  CHECK(paths == 2);
  CHECK(closed == 2);
}
