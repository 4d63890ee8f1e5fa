#include <doctest/doctest.h>

#include <cmath>

#include "geometry/keep_out.h"
#include "helpers/mesh_distance.h"
#include "helpers/shapes.h"
#include "transformesh/decimate.h"
#include "transformesh/errors.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using test::distance_of_meshes;

namespace {

/// A ball with a relief.
Mesh relief(int subdivisions, double radius) {
  Mesh mesh = test::icosphere(subdivisions);
  for (Vec3& p : mesh.positions)
    p *= radius * (1 + 0.1 * std::sin(5 * p.x()) * std::sin(5 * p.y()) * std::cos(4 * p.z()));
  return mesh;
}

}  // namespace

TEST_CASE("a shell around a relief keeps the gap while it becomes coarser") {
  const Mesh inner = relief(3, 1);
  const Mesh outer = relief(3, 1.03);
  const double gap = 0.01;
  REQUIRE(distance_of_meshes(inner, outer) > gap);
  RemeshOptions options;
  options.min_edge = 0.3;
  options.max_edge = 0.6;
  options.iterations = 3;
  Mesh free = outer;
  remesh(free, options);
  CHECK(distance_of_meshes(inner, free) == 0);

  Mesh kept = outer;
  options.keep_out = {&inner, gap};
  const RemeshResult result = remesh(kept, options);
  CHECK(result.kept_out > 0);
  CHECK(result.near_keep_out == 0);
  CHECK(result.collapses > 100);
  CHECK(distance_of_meshes(inner, kept) >= gap * (1 - 1e-9));
  CHECK(kept.faces.size() < outer.faces.size());
}

TEST_CASE("smoothing shrinks a shell onto what is inside, and stops there") {
  const Mesh inner = test::icosphere(2);
  Mesh outer = test::scaled(test::icosphere(2), 1.1);
  RemeshOptions options;
  options.min_edge = 0.01;
  options.max_edge = 10;
  options.only_smooth = true;
  options.smoothing = Smoothing::laplace;
  options.smooth_first = 1;
  options.iterations = 20;
  options.keep_out = {&inner, 0.02};
  CHECK(remesh(outer, options).kept_out > 0);
  const double distance = distance_of_meshes(inner, outer);
  CHECK(distance >= 0.02 * (1 - 1e-9));
  CHECK(distance < 0.05);
}

TEST_CASE("decimation keeps the gap as well, and reports if that ends it early") {
  const Mesh inner = relief(3, 1);
  Mesh outer = relief(3, 1.03);
  DecimateOptions options;
  options.faces = 1000;
  options.keep_out = {&inner, 0.01};
  const DecimateResult result = decimate(outer, options);
  CHECK(result.faces <= 1000);
  CHECK(distance_of_meshes(inner, outer) >= 0.01 * (1 - 1e-9));
  options.faces = 20;
  CHECK_THROWS_AS(decimate(outer, options), GoalError);
}
