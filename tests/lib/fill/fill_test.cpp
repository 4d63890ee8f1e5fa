/// Filled holes of balls and boxes, compared with the volumes of the original solids.
#include "transformesh/fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "helpers/shapes.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

/// Returns the mesh without the faces whose corners all lie above a height.
Mesh opened(Mesh mesh, double height) {
  std::erase_if(mesh.faces, [&](const Face& f) {
    return std::all_of(f.begin(), f.end(), [&](Index v) { return mesh.positions[v].z() > height; });
  });
  std::vector<bool> keep(mesh.faces.size(), true);
  return select_faces(mesh, keep);
}

void check_solid(const Mesh& mesh) {
  const ManifoldReport found = check_manifold(mesh);
  CHECK((found.is_manifold() && found.is_oriented() && found.is_closed()));
  CHECK(find_intersections(mesh).empty());
}

}  // namespace

TEST_CASE("a faired patch continues a ball, and what was there stays") {
  const Mesh open = opened(test::icosphere(4), 0.8);
  Mesh mesh = open;
  const FillResult result = fill_holes(mesh);
  check_solid(mesh);
  CHECK(result.holes == 1);
  CHECK(result.faired == 1);
  CHECK(result.new_vertices == mesh.positions.size() - open.positions.size());
  CHECK(std::equal(open.faces.begin(), open.faces.end(), mesh.faces.begin()));
  CHECK(std::equal(open.positions.begin(), open.positions.end(), mesh.positions.begin()));
  CHECK(volume(mesh) == doctest::Approx(volume(test::icosphere(4))).epsilon(0.005));

  // Without fairing the patch is flat, and the volume of a cap is missing.
  Mesh flat = open;
  CHECK(fill_holes(flat, {.fair = false}).refined == 1);
  check_solid(flat);
  CHECK(volume(flat) < 0.99 * volume(mesh));
}

TEST_CASE("a large patch is rejected for a single obstacle") {
  const Mesh open = opened(test::icosphere(5), 0.3);
  Mesh filled = open;
  CHECK(fill_holes(filled).new_faces > 2048);
  for (const double x : {0.0, 0.31, -0.52}) {
    Mesh needle = test::cube();
    for (Vec3& p : needle.positions) p = {x + 0.001 * p.x(), 0.1 + 0.001 * p.y(), 0.1 + p.z()};
    Mesh mesh = test::joined(open, needle);
    const FillResult result = fill_holes(mesh);
    CHECK(result.crossing.size() == 1);
    CHECK(result.new_faces == 0);
  }
}

TEST_CASE("without new vertices a box becomes the box that it was") {
  Mesh mesh = opened(test::cube(), 0.5);
  const FillResult result = fill_holes(mesh, {.refine = false});
  check_solid(mesh);
  CHECK(result.plain == 1);
  CHECK(result.new_vertices == 0);
  CHECK(mesh.faces.size() == 12);
  CHECK(volume(mesh) == doctest::Approx(1));
}

TEST_CASE("holes beyond the limits stay open") {
  for (const FillOptions& options :
       {FillOptions{.max_edges = 3}, FillOptions{.max_diameter = 1.4}}) {
    Mesh mesh = opened(test::cube(), 0.5);
    const FillResult result = fill_holes(mesh, options);
    REQUIRE(result.too_large.size() == 1);
    CHECK(result.too_large[0].edges == 4);
    CHECK(result.too_large[0].length == doctest::Approx(4));
    CHECK(mesh.faces.size() == 10);
  }
  Mesh mesh = opened(test::cube(), 0.5);
  CHECK(fill_holes(mesh, {.max_edges = 4, .max_diameter = 1.5}).filled() == 1);
}

TEST_CASE("a patch that would intersect the mesh stays out") {
  // A spike through the missing lid of the box.
  Mesh mesh =
      test::joined(opened(test::cube(), 0.5), test::cuboid({0.4, 0.4, 0.5}, {0.6, 0.6, 1.5}));
  const Mesh before = mesh;
  const FillResult result = fill_holes(mesh, {.fair = false});
  CHECK(result.crossing.size() == 1);
  CHECK(mesh.faces == before.faces);
  CHECK(mesh.positions == before.positions);
}

TEST_CASE("a slit, which has only flat patches, is not filled by intersecting faces") {
  // A cube with a new vertex in the middle of edge (0, 1). Only one of the two faces at the edge is
  // split there.
  for (const bool allows : {false, true}) {
    Mesh mesh = test::cube();
    mesh.positions.emplace_back(0.5, 0, 0);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      if (mesh.faces[f] == Face{0, 1, 4}) mesh.faces[f] = {0, 8, 4};
    mesh.faces.push_back({8, 1, 4});
    const FillResult result = fill_holes(mesh, {.allow_self_intersections = allows});
    CHECK(result.holes == 1);
    CHECK(result.flat.size() == 1);
    CHECK(result.crossing.empty());
    CHECK(result.filled() == 0);
  }
}

TEST_CASE("columns of new vertices are interpolated, those of new faces 0") {
  Mesh mesh = opened(test::icosphere(3), 0.7);
  for (double& x : mesh.vertex_columns.get("height", Scalar::float64, mesh.positions.size()).values)
    x = 5;
  for (double& x : mesh.face_columns.get("part", Scalar::int32, mesh.faces.size()).values) x = 7;
  const std::size_t old_faces = mesh.faces.size();
  REQUIRE(fill_holes(mesh).new_vertices > 0);
  const std::vector<double>& heights = mesh.vertex_columns.find("height")->values;
  REQUIRE(heights.size() == mesh.positions.size());
  for (const double x : heights) CHECK(x == doctest::Approx(5));
  const std::vector<double>& parts = mesh.face_columns.find("part")->values;
  REQUIRE(parts.size() == mesh.faces.size());
  for (std::size_t f = 0; f < parts.size(); ++f) CHECK(parts[f] == (f < old_faces ? 7 : 0));
}

TEST_CASE("meshes that are no oriented manifolds, and invalid limits, are refused") {
  Mesh mesh = test::cube();
  std::swap(mesh.faces[0][0], mesh.faces[0][1]);
  CHECK_THROWS_AS(fill_holes(mesh), InputError);
  mesh = test::cube();
  mesh.faces.push_back(mesh.faces[0]);
  CHECK_THROWS_AS(fill_holes(mesh), InputError);
  mesh = test::cube();
  CHECK_THROWS_AS(fill_holes(mesh, {.max_edges = 2}), UsageError);
  CHECK_THROWS_AS(fill_holes(mesh, {.max_diameter = 0}), UsageError);
  CHECK(fill_holes(mesh).holes == 0);
}
