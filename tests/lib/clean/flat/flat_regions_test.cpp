/// Regions consist of coplanar, connected faces with equal properties.
#include "clean/flat/flat_regions.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "lib/clean/flat/flat_shapes.h"
#include "mesh/adjacency.h"
#include "mesh/coordinate_spacing.h"

using namespace transformesh;

namespace {

FlatRegions regions_of(const Mesh& mesh, double spacings = 64) {
  const std::vector<char> wanted(mesh.faces.size(), 1);
  return find_flat_regions(mesh, opposite_halfedges(mesh), wanted, spacings, Scalar::float64);
}

}  // namespace

TEST_CASE("every side of a body is a region") {
  const FlatRegions cube = regions_of(test::grid_cube(5));
  CHECK(cube.regions.size() == 6);
  for (const FlatRegion& region : cube.regions) {
    CHECK(region.faces.size() == 50);
    CHECK(region.low == 0);
    CHECK(region.high == 0);
    CHECK(region.normal.cwiseAbs().maxCoeff() == doctest::Approx(1));
  }
  CHECK(regions_of(test::grid_frame(3)).regions.size() == 10);
}

TEST_CASE("a curved surface has no region") {
  CHECK(regions_of(test::icosphere(3)).regions.empty());
}

TEST_CASE("a region grows by its fitted plane, beyond the plane of its first face") {
  // Rows of vertices that deviate increasingly from the plane of the first triangle.
  Mesh mesh = test::grid(40);
  const double spacing = spacing_around(Vec3::Ones(), Scalar::float64);
  for (Vec3& point : mesh.positions) point.z() = 1 + std::round(150 * point.x()) * 2 * spacing;
  const FlatRegions found = regions_of(mesh);
  CHECK(found.regions.size() == 1);
  CHECK(found.regions.front().faces.size() == mesh.faces.size());
}

TEST_CASE("faces beyond the tolerance are in another region, and all are within it") {
  Mesh mesh = test::grid(16);
  for (Vec3& point : mesh.positions) point.z() = std::max(0., point.x() - .5);
  const FlatRegions found = regions_of(mesh);
  REQUIRE(found.regions.size() == 2);
  for (const FlatRegion& region : found.regions) {
    CHECK(region.faces.size() == mesh.faces.size() / 2);
    CHECK(region.high - region.low < 1e-14);
    for (const Index face : region.faces)
      for (const Index v : mesh.faces[face])
        CHECK(std::abs(region.normal.dot(mesh.positions[v] - region.point)) < 1e-14);
  }
}

TEST_CASE("faces with other properties are in other regions, lists included") {
  Mesh mesh = test::grid(4);
  Column& column = mesh.face_columns.get("part", Scalar::int32, mesh.faces.size());
  for (Index f = 0; f < mesh.faces.size(); ++f) column.values[f] = f < 8 ? 0 : 1;
  CHECK(regions_of(mesh).regions.size() == 2);
}

TEST_CASE("only regions with wanted faces are found") {
  const Mesh mesh = test::grid_cube(3);
  std::vector<char> wanted(mesh.faces.size(), 0);
  const std::vector<Index> opposites = opposite_halfedges(mesh);
  CHECK(find_flat_regions(mesh, opposites, wanted, 64, Scalar::float64).regions.empty());
  wanted[0] = 1;
  const FlatRegions found = find_flat_regions(mesh, opposites, wanted, 64, Scalar::float64);
  REQUIRE(found.regions.size() == 1);
  CHECK(found.regions[0].faces.size() == 18);
  CHECK(found.of_face[0] == 0);
  CHECK(std::count(found.of_face.begin(), found.of_face.end(), no_index) ==
        static_cast<long>(mesh.faces.size()) - 18);
}
