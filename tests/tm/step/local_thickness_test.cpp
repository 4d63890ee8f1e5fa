#include "tm/step/local_thickness.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "helpers/shapes.h"
#include "tm/step/morph_step.h"
#include "tm/step/target_file.h"
#include "tm/support/parallel.h"

using namespace transformesh;
using doctest::Approx;

namespace {

constexpr double wide = std::numeric_limits<double>::infinity();

/// Two balls of radius 1 whose surfaces are `gap` apart on the x axis.
Mesh two_balls(double gap) {
  Mesh mesh = test::icosphere(4);
  const std::size_t count = mesh.positions.size();
  const std::size_t faces = mesh.faces.size();
  for (std::size_t v = 0; v < count; ++v)
    mesh.positions.push_back(mesh.positions[v] + Vec3(2 + gap, 0, 0));
  for (std::size_t f = 0; f < faces; ++f) {
    Face face = mesh.faces[f];
    for (Index& corner : face) corner += static_cast<Index>(count);
    mesh.faces.push_back(face);
  }
  return mesh;
}

/// The wall between two spheres around the origin.
Mesh shell(double thickness) {
  Mesh mesh = test::icosphere(4);
  const Mesh outer = mesh;
  for (const Vec3& point : outer.positions) mesh.positions.push_back((1 - thickness) * point);
  const auto count = static_cast<Index>(outer.positions.size());
  for (const auto& [a, b, c] : outer.faces) mesh.faces.push_back({a + count, c + count, b + count});
  return mesh;
}

/// The diameter of the ball that touches the left ball at `point` from outside and the right one:
/// its center lies at (1 + r) point, and 1 + r from the center of the right one.
double width_between_balls(const Vec3& point, double gap) {
  const double apart = 2 + gap;
  double low = 0;
  double high = 10;
  for (int i = 0; i < 60; ++i) {
    const double r = (low + high) / 2;
    const bool reaches = ((1 + r) * point - Vec3(apart, 0, 0)).norm() < 1 + r;
    (reaches ? high : low) = r;
  }
  return 2 * low;
}

}  // namespace

TEST_CASE("the gap between two balls has the width of the balls that fit in") {
  const double gap = 0.1;
  const double reach = 0.5;
  const Mesh mesh = two_balls(gap);
  const std::vector<double> widths = local_thickness(make_target(mesh), reach);
  std::size_t narrow = 0;
  for (std::size_t v = 0; v < mesh.positions.size() / 2; ++v) {
    const double expected = width_between_balls(mesh.positions[v], gap);
    // The normals at both contacts are mirror images: 120 degrees apart 30 degrees off the axis.
    const double off_axis = std::acos(mesh.positions[v].x()) * 180 / std::numbers::pi;
    if (expected > 1.1 * reach || off_axis > 32) {
      CHECK(widths[v] == wide);
    } else if (expected < 0.9 * reach && off_axis < 28) {
      // The flat faces lie inside the balls.
      CHECK(widths[v] == Approx(expected).epsilon(0.1));
      ++narrow;
    }
  }
  CHECK(narrow > 10);
}

TEST_CASE("walls are narrow, corners, edges and curved places are not") {
  const auto widths = [](const Mesh& mesh, double reach) {
    return local_thickness(make_target(mesh), reach);
  };
  for (const double width : widths(shell(0.1), 0.5)) CHECK(width == Approx(0.1).epsilon(0.02));
  for (const double width : widths(test::cuboid(Vec3(0, 0, 0), Vec3(1, 1, 1)), 0.5))
    CHECK(width == wide);
  for (const double width : widths(test::icosphere(3), 0.5)) CHECK(width == wide);
  for (const double width : widths(test::torus(1, 0.4, 60, 30), 0.5)) CHECK(width == wide);
}

TEST_CASE("of points too; the file of a target keeps them") {
  Mesh points = two_balls(0.1);
  std::vector<Vec3> normals = points.positions;
  for (std::size_t v = normals.size() / 2; v < normals.size(); ++v) normals[v].x() -= 2.1;
  points.faces.clear();
  set_normal_columns(points, normals);
  Target target = make_target(points);
  target.thickness = local_thickness(target, 0.5);
  CHECK(*std::min_element(target.thickness.begin(), target.thickness.end()) ==
        Approx(0.1).epsilon(0.1));
  CHECK(read_target(write_target(target), "a.ply").thickness == target.thickness);
}

TEST_CASE("a step says how long edges may be: short ones in the gap, and bounded") {
  Target target = make_target(two_balls(0.1));
  target.thickness = local_thickness(target, 0.6);
  Mesh mesh = test::icosphere(3);
  for (Vec3& point : mesh.positions) point *= 1.01;
  MorphStepOptions options;
  options.gap_edges = 2;
  options.largest_size = 0.3;
  morph_step(mesh, target, options);
  const Column* sizes = mesh.vertex_columns.find("size");
  REQUIRE(sizes != nullptr);
  const auto [least, most] = std::minmax_element(sizes->values.begin(), sizes->values.end());
  CHECK(*least == Approx(0.05).epsilon(0.1));
  CHECK(*most == 0.3);
}

TEST_CASE("gaps do not depend on the number of threads") {
  const Target target = make_target(two_balls(0.2));
  const std::vector<double> alone = [&] {
    const ThreadLimit limit(1);
    return local_thickness(target, 1);
  }();
  CHECK(local_thickness(target, 1) == alone);
}
