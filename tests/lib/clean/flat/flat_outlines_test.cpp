/// Vertices are removed inside of regions and on straight edges, and stay at corners, borders and
/// contacts.
#include "clean/flat/flat_outlines.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/shapes.h"
#include "lib/clean/flat/flat_shapes.h"
#include "mesh/adjacency.h"

using namespace transformesh;

namespace {

/// A mesh, its regions and their outlines.
struct Outlined {
  explicit Outlined(Mesh of) : mesh(std::move(of)) { find(std::vector<char>(size(), 0)); }
  Outlined(Mesh of, const std::vector<char>& copies) : mesh(std::move(of)) { find(copies); }
  std::size_t size() const { return mesh.positions.size(); }
  std::size_t staying() const {
    std::size_t count = 0;
    for (Index v = 0; v < size(); ++v) count += outlines->goes(v) ? 0 : 1;
    return count;
  }
  void find(const std::vector<char>& copies) {
    has_copy = copies;
    opposites = opposite_halfedges(mesh);
    flat = find_flat_regions(mesh, opposites, std::vector<char>(mesh.faces.size(), 1), 64,
                             Scalar::float64);
    surface.emplace(FlatSurface{mesh, opposites, has_copy, 64, Scalar::float64});
    outlines.emplace(*surface, flat.of_face);
  }

  Mesh mesh;
  std::vector<char> has_copy;
  std::vector<Index> opposites;
  FlatRegions flat;
  std::optional<FlatSurface> surface;
  std::optional<FlatOutlines> outlines;
};

}  // namespace

TEST_CASE("the outline of a cube's side has its four corners in order") {
  Outlined cube(test::grid_cube(4));
  CHECK(cube.staying() == 8);
  CHECK(cube.outlines->movement() == 0);
  for (const FlatRegion& region : cube.flat.regions) {
    CHECK(cube.outlines->changes(region));
    const RegionOutlines left = cube.outlines->of(region);
    REQUIRE(left.outlines.size() == 1);
    CHECK(left.outlines[0].size() == 4);
    CHECK(left.faces == 2);
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i)
      area += cube.mesh.positions[left.outlines[0][i]].cross(
          cube.mesh.positions[left.outlines[0][(i + 1) % 4]]);
    CHECK((area / 2 - region.normal).norm() < 1e-12);
  }
}

TEST_CASE("a side with a hole has two outlines, and as many triangles as both need") {
  Outlined frame(test::grid_frame(3));
  std::size_t with_hole = 0;
  for (const FlatRegion& region : frame.flat.regions) {
    const RegionOutlines left = frame.outlines->of(region);
    if (left.outlines.size() == 1) continue;
    ++with_hole;
    CHECK(left.outlines.size() == 2);
    CHECK(left.faces == 8);
  }
  CHECK(with_hole == 2);
}

TEST_CASE("the border of an open sheet is straightened") {
  Outlined sheet(test::grid(6));
  CHECK(sheet.staying() == 4);
  CHECK(sheet.outlines->of(sheet.flat.regions[0]).faces == 2);
}

TEST_CASE("vertices with copies stay, and the edges between them") {
  const Mesh mesh = test::grid(4);
  std::vector<char> has_copy(mesh.positions.size(), 0);
  const auto mark = [&](const Vec3& point) {
    const auto found = std::find(mesh.positions.begin(), mesh.positions.end(), point);
    has_copy[static_cast<std::size_t>(found - mesh.positions.begin())] = 1;
  };
  mark({.5, .5, 0});
  Outlined single(mesh, has_copy);
  CHECK(single.staying() == 5);
  RegionOutlines left = single.outlines->of(single.flat.regions[0]);
  CHECK(left.outlines.size() == 2);
  CHECK(left.faces == 4);

  mark({.5, .25, 0});
  Outlined edge(mesh, has_copy);
  CHECK(edge.staying() == 6);
  left = edge.outlines->of(edge.flat.regions[0]);
  CHECK(left.faces == 6);
  CHECK(std::count_if(left.outlines.begin(), left.outlines.end(),
                      [](const auto& outline) { return outline.size() == 2; }) == 1);
}

TEST_CASE("a region that cannot be merged keeps its vertices") {
  Outlined cube(test::grid_cube(4));
  std::vector<Index> of_face = cube.flat.of_face;
  for (const Index face : cube.flat.regions[2].faces) of_face[face] = no_index;
  const FlatOutlines outlines(*cube.surface, of_face);
  for (const Index face : cube.flat.regions[2].faces)
    for (const Index v : cube.mesh.faces[face]) CHECK(!outlines.goes(v));
}

TEST_CASE("an edge bent within the tolerance is straightened, and the displacement reported") {
  Mesh mesh = test::grid_cube(4);
  for (Vec3& point : mesh.positions)
    if (point == Vec3(1, 1, .5)) point -= Vec3(1e-15, 1e-15, 0);
  const Outlined cube(mesh);
  CHECK(cube.staying() == 8);
  CHECK(cube.outlines->movement() > 1e-15);
  CHECK(cube.outlines->movement() < 2e-15);
}
