/// Bodies that touch along an edge at which faces are missing, and holes with tongues of faces.
/// Volumes are computed without the library.
#include "fill/contact_edges.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/fill.h"
#include "transformesh/manifold.h"
#include "transformesh/repair.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

/// Two boxes that touch along the edge from the origin to (0, 0, length), one after the other.
Mesh touching_boxes(double length) {
  return test::joined(test::cuboid({-1, -1, 0}, {0, 0, length}),
                      test::cuboid({0, 0, 0}, {1, 1, length}));
}

/// Returns the mesh without the faces of these numbers among those at the contact edge.
Mesh without(const Mesh& mesh, const std::vector<std::size_t>& dropped) {
  const auto is_end = [&](Index v) {
    return mesh.positions[v].x() == 0 && mesh.positions[v].y() == 0;
  };
  Mesh result{mesh.positions, {}, {}, {}};
  std::size_t number = 0;
  for (const Face& face : mesh.faces) {
    const bool is_at_edge = std::ranges::count_if(face, is_end) == 2;
    if (!is_at_edge || std::ranges::count(dropped, number++) == 0) result.faces.push_back(face);
  }
  CHECK(number == 4);
  return result;
}

Mesh moved_by(Mesh mesh, const Eigen::Matrix3d& linear) {
  for (Vec3& p : mesh.positions) p = linear * p;
  return mesh;
}

std::size_t cuts_of(Mesh mesh) {
  std::vector<Face> separate = mesh.faces;
  std::vector<HoleLoop> loops = join_touching_holes(mesh, check_manifold(mesh).border_halfedges);
  return cut_contact_edges(mesh, separate, loops, [](const HoleLoop&) { return true; });
}

}  // namespace

TEST_CASE("a face of each of two bodies is missing at the edge along which they touch") {
  Eigen::Matrix3d turned;
  turned = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized());
  Eigen::Matrix3d sheared = Eigen::Matrix3d::Identity();
  sheared(0, 1) = 0.5;
  for (const double length : {0.2, 1.0, 10.0})
    for (const Eigen::Matrix3d& linear : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), turned,
                                          sheared, Eigen::Matrix3d(turned * sheared)})
      for (const std::size_t first : {0, 1})
        for (const std::size_t second : {2, 3}) {
          CAPTURE(length);
          CAPTURE(first);
          CAPTURE(second);
          const Mesh mesh = moved_by(without(touching_boxes(length), {first, second}), linear);
          for (const Mesh& input : {mesh, test::soup_of(mesh)}) {
            const RepairResult result = repair(input);
            CHECK(test::count(result.mesh).is_closed_and_oriented);
            CHECK(test::signed_volume(result.mesh) == doctest::Approx(2 * length).epsilon(1e-9));
          }
        }
}

TEST_CASE("ends of a cut edge keep their columns, and holes beyond the limits are not cut") {
  const auto value_at = [](const Vec3& p) { return p.x() + 10 * p.y() + 100 * p.z(); };
  int filled = 0;
  for (const std::size_t second : {2, 3}) {
    Mesh mesh = without(touching_boxes(1), {0, second});
    if (stitch(mesh).misoriented_edges > 0) continue;
    const std::size_t count = mesh.positions.size();
    Column& column = mesh.vertex_columns.get("value", Scalar::float64, count);
    for (std::size_t v = 0; v < count; ++v) column.values[v] = value_at(mesh.positions[v]);
    Mesh uncut = mesh;
    CHECK(fill_holes(uncut, {.max_diameter = 0.5}).too_large.size() == 1);
    CHECK(uncut.faces == mesh.faces);
    const FillResult result = fill_holes(mesh, {.max_edges = 3});
    CHECK(result.plain == 2);
    CHECK(result.cut_edges == 1);
    CHECK(test::count(mesh).is_closed_and_oriented);
    CHECK(mesh.positions.size() == 16);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      CHECK(mesh.vertex_columns.columns[0].values[v] == value_at(mesh.positions[v]));
    ++filled;
  }
  CHECK(filled == 1);
}

TEST_CASE("tongues of faces in holes are no bodies") {
  const Mesh ball = test::icosphere(3);
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    test::Random random(seed);
    Mesh mesh{ball.positions, {}, {}, {}};
    const double height = random.uniform(-0.5, 0.9), share = random.uniform(0, 1);
    for (const Face& face : ball.faces)
      if (ball.positions[face[0]].z() < height || random.uniform(0, 1) < share)
        mesh.faces.push_back(face);
    stitch(mesh);
    CAPTURE(seed);
    CHECK(cuts_of(mesh) == 0);
  }
}
