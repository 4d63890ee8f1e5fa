#include "step/local_thickness.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/search/closest_point.h"
#include "helpers/shapes.h"
#include "step/morph_step_query.h"
#include "step/prepare_target.h"
#include "step/target_file.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/measure.h"
#include "transformesh/morph_step.h"

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

/// Returns the diameter of the ball that touches the left ball at `point` from outside, and the
/// right one. Its center lies at (1 + r) point, at the distance 1 + r from the center of the right
/// one.
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

/// The plate [-10, 10]^2 x [0, 2] with a window of width `width` in its middle. All of its vertices
/// are on sharp edges; vertices 8 to 15 are at the window.
Mesh plate_with_window(double width) {
  Mesh mesh;
  for (const double half : {10.0, width / 2})
    for (const double z : {0.0, 2.0})
      for (int i = 0; i < 4; ++i)
        mesh.positions.emplace_back(i == 0 || i == 3 ? -half : half, i < 2 ? -half : half, z);
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    for (const auto& [a, b, c, d] : {std::array{i, j, j + 4, i + 4},            // outside
                                     std::array{j + 8, i + 8, i + 12, j + 12},  // window
                                     std::array{i + 4, j + 4, j + 12, i + 12},  // top
                                     std::array{j, i, i + 8, j + 8}})           // bottom
      mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
  }
  return mesh;
}

/// Returns the diameter of the smallest ball that touches the mesh at the point and also a face
/// whose normal is more than 120 degrees from `normal`. Its center lies along `direction`. Found by
/// bisection over all faces.
double width_by_search(const Mesh& mesh, const Vec3& point, const Vec3& normal,
                       const Vec3& direction, double reach) {
  const auto meets = [&](double radius) {
    const Vec3 center = point + radius * direction;
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Face& f) {
      const Vec3 &a = mesh.positions[f[0]], &b = mesh.positions[f[1]], &c = mesh.positions[f[2]];
      const bool faces = (b - a).cross(c - a).normalized().dot(normal) < -0.5;
      return faces && a != point && b != point && c != point &&
             (closest_point_of_triangle(center, a, b, c).point - center).norm() < radius;
    });
  };
  if (!meets(reach / 2)) return wide;
  double low = 0;
  double high = reach / 2;
  for (int i = 0; i < 60; ++i) (meets((low + high) / 2) ? high : low) = (low + high) / 2;
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
    // The normals at both contacts are mirror images: they are 120 degrees apart at 30 degrees off
    // the axis.
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

TEST_CASE("balls inside of a surface measure its walls, but not its gaps") {
  const auto widths = [](const Mesh& mesh) {
    return local_thickness(make_target(mesh), 0.5, {}, BallSides::inside);
  };
  for (const double width : widths(two_balls(0.1))) CHECK(width == wide);
  for (const double width : widths(shell(0.1))) CHECK(width == Approx(0.1).epsilon(0.02));
}

TEST_CASE("a window is as narrow at its rim as inside, though all vertices are on sharp edges") {
  for (const double width : {0.3, 0.5, 0.51, 1.0}) {
    const Mesh plate = plate_with_window(width);
    for (const double reach : {1.3, 1.9, 1.96}) {
      const std::vector<double> widths = local_thickness(make_target(plate), reach);
      for (std::size_t v = 0; v < 8; ++v) CHECK(widths[v] == wide);
      for (std::size_t v = 8; v < 16; ++v) CHECK(widths[v] == Approx(width).epsilon(0.06));
    }
    // The wall of the plate is 2 thick.
    for (const double thick : local_thickness(make_target(plate), 5)) CHECK(thick < 2.11);
    const Target target = make_target(plate);
    CHECK(local_thickness_near(target, Vec3(0.1, -width / 2, 1), 1.9) ==
          Approx(width).epsilon(0.06));
    CHECK(local_thickness_near(target, Vec3(0.1, -width / 2, 2), 1.9) ==
          Approx(width).epsilon(0.06));
    CHECK(local_thickness_near(target, Vec3(5, 5, 2.5), 1.9) == wide);
  }
}

TEST_CASE("thickness at vertices agrees with a search over all faces") {
  Mesh mesh = test::icosphere(2);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.positions[v] *= v % 3 == 0 ? 0.7 : 1.2;
  const double reach = 1;
  const std::vector<double> widths = local_thickness(make_target(mesh), reach);
  const std::vector<Vec3> normals = vertex_normals(mesh);
  std::size_t narrow = 0;
  for (std::size_t v = 0; v < widths.size(); ++v) {
    double least = wide;
    const auto offer = [&](const Vec3& normal) {
      for (const double side : {1.0, -1.0})
        least =
            std::min(least, width_by_search(mesh, mesh.positions[v], normal, side * normal, reach));
    };
    offer(normals[v]);
    // local_thickness() skips a face whose normal differs by less than 20 degrees from a normal
    // already tested. Thus the search over all faces gives only a lower bound.
    const double by_vertex = least;
    for (const Face& f : mesh.faces)
      if (std::find(f.begin(), f.end(), v) != f.end())
        offer((mesh.positions[f[1]] - mesh.positions[f[0]])
                  .cross(mesh.positions[f[2]] - mesh.positions[f[0]])
                  .normalized());
    CHECK(widths[v] >= 0.999 * least);
    CHECK(widths[v] <= 1.06 * by_vertex);
    narrow += widths[v] < wide ? 1 : 0;
  }
  CHECK(narrow > 10);
}

TEST_CASE("a blade is as thin at its edge as faces beside it show, and not nothing") {
  // A wedge of 20 degrees with its edge along x.
  const double slope = std::tan(20 * std::numbers::pi / 180);
  Mesh wedge;
  wedge.positions = {{0, 0, 0}, {5, 0, 0},         {0, 5, 0},
                     {5, 5, 0}, {0, 5, 5 * slope}, {5, 5, 5 * slope}};
  wedge.faces = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4},
                 {2, 4, 3}, {3, 4, 5}, {0, 4, 2}, {1, 3, 5}};
  const Target target = with_thickness(make_target(wedge), 1.5, 0.5);
  CHECK(*std::min_element(target.thickness.begin(), target.thickness.end()) > 0.05);
}

TEST_CASE("a gap between large faces is found although no vertex is near") {
  // Two crossed bars 0.2 apart, far from all of their corners.
  const Mesh bars =
      test::joined(test::cuboid({-5, -1, 0}, {5, 1, 2}), test::cuboid({-1, -5, 2.2}, {1, 5, 4.2}));
  const Target target = make_target(bars);
  for (const double width : local_thickness(target, 1.5)) CHECK(width == wide);
  const Target split = with_thickness(target, 1.5, 1);
  REQUIRE(split.thickness.size() == split.mesh.positions.size());
  std::size_t narrow = 0;
  for (std::size_t v = 0; v < split.thickness.size(); ++v) {
    const Vec3& p = split.mesh.positions[v];
    const bool is_between =
        std::abs(p.x()) < 1 && std::abs(p.y()) < 1 && p.z() > 1.9 && p.z() < 2.3;
    if (is_between) CHECK(split.thickness[v] == Approx(0.2).epsilon(0.06));
    if (p.cwiseAbs().maxCoeff() > 4.5) CHECK(split.thickness[v] == wide);
    narrow += is_between ? 1 : 0;
  }
  CHECK(narrow > 10);
  CHECK(read_target(write_target(split), "a.ply").thickness == split.thickness);
}

TEST_CASE("thickness of point sets is measured too, and stored in target files") {
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

TEST_CASE("a step stores edge lengths: short ones in the gap, and bounded") {
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
