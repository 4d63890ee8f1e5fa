/// Cracks of known widths, and borders that are not cracks.
#include "repair/crack_tolerance.h"

#include <doctest/doctest.h>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/manifold.h"
#include "transformesh/stitch.h"

using namespace transformesh;

namespace {

Mesh jittered(const Mesh& solid, double width) {
  test::Random random(1);
  Mesh soup = test::soup_of(solid);
  for (Vec3& point : soup.positions) point += random.point(-width / 2, width / 2);
  return soup;
}

/// The lower half of a ball, with a border.
Mesh bowl() {
  Mesh ball = test::icosphere(3);
  std::erase_if(ball.faces, [&](const Face& face) { return ball.positions[face[0]].z() > 0; });
  return ball;
}

}  // namespace

TEST_CASE("the measured width is that of the cracks, and the tolerance closes them") {
  for (const Mesh& solid : {test::icosphere(3), test::cube(), test::torus(2, 0.7, 40, 24)}) {
    for (const double width : {1e-12, 1e-9, 1e-6, 1e-4}) {
      CAPTURE(width);
      Mesh mesh = jittered(solid, width);
      const Cracks cracks = find_cracks(mesh);
      CHECK(cracks.width > 0.1 * width);
      CHECK(cracks.width < 1.8 * width);
      CHECK(cracks.tolerance >= cracks.width);
      CHECK(cracks.tolerance <= 4 * cracks.width);
      CHECK(cracks.vertices == mesh.positions.size());
      stitch(mesh, {.tolerance = cracks.tolerance});
      CHECK(check_manifold(mesh).is_closed());
      CHECK(mesh.faces.size() == solid.faces.size());
    }
  }
}

TEST_CASE("copies of a body with cracks hide no cracks, whatever their orientation") {
  const Mesh solid = test::icosphere(3);
  for (const Mesh& copy : {solid, test::reversed(solid)}) {
    Mesh mesh = jittered(test::joined(solid, copy), 1e-6);
    const Cracks cracks = find_cracks(mesh);
    CHECK(cracks.width > 1e-7);
    CHECK(cracks.width < 1.8e-6);
    CHECK(cracks.vertices == mesh.positions.size());
  }
  // One half of both copies is displaced, so that equal edges have two faces.
  Mesh halves = solid;
  for (Face& face : halves.faces) {
    if (solid.positions[face[0]].x() < 0) continue;
    for (Index& v : face) {
      halves.positions.push_back(solid.positions[v] + Vec3(1e-6, 1e-6, 0));
      v = static_cast<Index>(halves.positions.size() - 1);
    }
  }
  CHECK(find_cracks(halves).width > 1e-7);
  CHECK(find_cracks(test::joined(halves, halves)).width == find_cracks(halves).width);
}

TEST_CASE("a few faces as short as the cracks are wide do not hide the cracks") {
  Mesh solid = test::icosphere(3);
  const std::size_t faces = solid.faces.size();
  for (Index f = 0; f < 10; ++f) {
    const auto& [a, b, c] = solid.faces[100 * f];
    solid.faces.push_back({a, a, b});
  }
  Mesh mesh = jittered(solid, 1e-6);
  const Cracks cracks = find_cracks(mesh);
  CHECK(cracks.width > 1e-7);
  CHECK(cracks.width < 1.8e-6);
  const StitchResult result = stitch(mesh, {.tolerance = cracks.tolerance});
  CHECK(check_manifold(mesh).is_closed());
  CHECK(result.dropped_faces == 10);
  CHECK(mesh.faces.size() == faces);
}

TEST_CASE("closed meshes, soups with equal places and open meshes have no cracks") {
  CHECK(find_cracks(test::icosphere(2)).tolerance == 0);
  CHECK(find_cracks(test::soup_of(test::icosphere(2))).tolerance == 0);
  CHECK(find_cracks(bowl()).tolerance == 0);
  CHECK(find_cracks(test::grid(5)).tolerance == 0);
  CHECK(find_cracks(Mesh()).tolerance == 0);
}

TEST_CASE("a gap that is not clearly narrower than the edges is a slot") {
  Mesh right = test::moved(test::grid(5), {1.0001, 0, 0});
  CHECK(find_cracks(test::joined(test::grid(5), right)).tolerance > 0);
  right = test::moved(test::grid(5), {1.1, 0, 0});
  CHECK(find_cracks(test::joined(test::grid(5), right)).tolerance == 0);
}

TEST_CASE("the rims of a thin plate fold back, and are no cracks") {
  const Mesh top = test::grid(5);
  const Mesh below = test::reversed(test::moved(top, {0, 0, -1e-4}));
  CHECK(find_cracks(test::joined(top, below)).tolerance == 0);
}

TEST_CASE("a vertex on an edge is a crack of width 0, and the tolerance splits the edge") {
  // One side of the square's diagonal is split in the middle.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  mesh.faces = {{0, 1, 2}, {0, 4, 3}, {4, 2, 3}};
  const Cracks cracks = find_cracks(mesh);
  CHECK(cracks.vertices == 1);
  CHECK(cracks.place == mesh.positions[4]);
  CHECK(cracks.tolerance > 0);
  const StitchResult result = stitch(mesh, {.tolerance = cracks.tolerance});
  CHECK(result.split_borders == 1);
  CHECK(mesh.faces.size() == 4);
  CHECK(check_manifold(mesh).boundary_loops == 1);
  CHECK(check_manifold(mesh).border_halfedges.size() == 4);
}
