#include "transformesh/check_mesh.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

Mesh overlapping_boxes() {
  return test::joined(test::cuboid(Vec3::Zero(), Vec3::Ones()),
                      test::cuboid(Vec3::Constant(.5), Vec3::Constant(1.5)));
}

}  // namespace

TEST_CASE("a box has no problem, and an open box only if it must be closed") {
  CHECK(check_mesh(test::cube()).problems.empty());
  Mesh open = test::cube();
  open.faces.pop_back();
  CHECK(check_mesh(open).problems.empty());
  CheckMeshOptions options;
  options.closed = true;
  const MeshCheck check = check_mesh(open, options);
  REQUIRE(check.problems.size() == 1);
  CHECK(check.problems[0].kind == ErrorKind::not_closed);
}

TEST_CASE("self-intersections are searched for if they are a problem") {
  const Mesh boxes = overlapping_boxes();
  CHECK(!check_mesh(boxes).intersections);
  CheckMeshOptions options;
  options.intersections = true;
  const MeshCheck check = check_mesh(boxes, options);
  REQUIRE(check.intersections);
  CHECK(!check.intersections->empty());
  REQUIRE(check.problems.size() == 1);
  CHECK(check.problems[0].kind == ErrorKind::self_intersections);
  CHECK(check.problems[0].data.counts == std::vector<std::size_t>{check.intersections->size()});
}

TEST_CASE("a certificate holds for the cleaned mesh and fails for the mesh without a face moved") {
  const Mesh input = overlapping_boxes();
  Mesh cleaned = clean(input).mesh;
  CheckMeshOptions options;
  options.certified = &input;
  CHECK(check_mesh(cleaned, options).problems.empty());
  options.winding_level = 2;
  const MeshCheck check = check_mesh(cleaned, options);
  REQUIRE(check.certificate);
  CHECK(check.certificate->wrong > 0);
  CHECK(check.problems.size() == 1);
  options.winding_level = 0;
  CHECK_THROWS_AS(check_mesh(cleaned, options), UsageError);
}

TEST_CASE("with a certificate, a face without area is a problem") {
  Mesh input = test::cube();
  Mesh output = input;
  output.positions.push_back({.5, 0, 0});  // on the edge from vertex 0 to vertex 1
  output.faces[0] = {0, 2, 8};
  output.faces.push_back({2, 1, 8});
  output.faces[1] = {1, 2, 3};
  output.faces[4] = {0, 8, 4};
  output.faces.push_back({8, 1, 4});
  CheckMeshOptions options;
  options.certified = &input;
  CHECK(check_mesh(output, options).problems.empty());
  output.positions[8] = {0, 0, 0};
  const MeshCheck check = check_mesh(output, options);
  CHECK(check.degenerate_faces > 0);
  CHECK(!check.problems.empty());
}
