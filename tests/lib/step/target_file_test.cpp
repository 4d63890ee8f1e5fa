#include "step/target_file.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "geometry/search/closest_point.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

TEST_CASE("a mesh as target reads back as it was") {
  const Target target = make_target(test::icosphere(2));
  const Target again = read_target(write_target(target), "a.ply");
  CHECK(again.is_mesh());
  CHECK(again.mesh.positions == target.mesh.positions);
  CHECK(again.mesh.faces.size() == target.mesh.faces.size());
  CHECK(std::is_permutation(again.mesh.faces.begin(), again.mesh.faces.end(),
                            target.mesh.faces.begin()));
  CHECK(!target.has_spatial_order);
  CHECK(again.has_spatial_order);
  // Both targets give the same closest points.
  const ClosestPointQuery before(target.mesh,
                                 target.has_spatial_order ? FaceOrder::spatial : FaceOrder::any);
  const ClosestPointQuery after(again.mesh,
                                again.has_spatial_order ? FaceOrder::spatial : FaceOrder::any);
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec3 query = random.point(-2, 2);
    CHECK(after(query).signed_distance == before(query).signed_distance);
  }
}

TEST_CASE("points read back with the normals that were estimated for them") {
  Mesh points;
  points.positions = test::icosphere(2).positions;
  const Target target = make_target(points);
  REQUIRE(target.has_estimated_normals);
  const Target again = read_target(write_target(target), "a.ply");
  CHECK_FALSE(again.is_mesh());
  CHECK_FALSE(again.has_estimated_normals);
  CHECK(again.mesh.positions == target.mesh.positions);
  for (std::size_t p = 0; p < points.positions.size(); ++p)
    CHECK((again.normals[p] - target.normals[p]).norm() < 1e-15);
}

TEST_CASE("text and meshes are distinguished") {
  CHECK(read_target("1 0 0 1 0 0\n0 1 0 0 2 0\n", "a.P3D").normals[1] == Vec3(0, 1, 0));
  CHECK(read_target("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off").is_mesh());
}

TEST_CASE("a target read has its faces in one order, whether it was written in between or not") {
  Document document;
  document.mesh = test::torus(1, 0.4, 20, 10);
  const Target direct = read_target(write_mesh(document).bytes, "a.ply");
  const Target again = read_target(write_target(direct), "b.ply");
  CHECK(direct.mesh.faces != document.mesh.faces);
  CHECK(direct.mesh.faces == again.mesh.faces);
  CHECK(direct.has_spatial_order);
}
