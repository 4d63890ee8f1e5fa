#include "clean/intersect/rounding_intersections.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"

using namespace transformesh;

namespace {

/// A triangle in the plane z = 0, and one whose tip is `height` above its middle.
Mesh tip_above(double height) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, height}, {1, 1, 1}, {2, 1, 1}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

}  // namespace

TEST_CASE("a tip that rounding puts onto a face is one pair") {
  const Mesh exact = tip_above(1e-3);
  CHECK(count_rounding_intersections(tip_above(0), exact.positions) == 1);
}

TEST_CASE("a pair that met before rounding does not count") {
  const Mesh exact = tip_above(-1e-3);
  CHECK(count_rounding_intersections(tip_above(0), exact.positions) == 0);
  CHECK(count_rounding_intersections(exact, exact.positions) == 0);
}

TEST_CASE("only new intersections count") {
  const Mesh exact = test::joined(tip_above(1e-3), test::moved(tip_above(-1e-3), {10, 0, 0}));
  const Mesh rounded = test::joined(tip_above(0), test::moved(tip_above(0), {10, 0, 0}));
  CHECK(count_rounding_intersections(rounded, exact.positions) == 1);
}

TEST_CASE("rounding to floats is tested if their spacing is close to edge lengths") {
  // At 2^22 floats are multiples of 1/2, so the tip at 1/8 is rounded onto the face.
  const Mesh mesh = test::moved(tip_above(.125), {0, 0, 1 << 22});
  CHECK(count_rounding_intersections(mesh, Scalar::float32) == 1);
  CHECK(count_rounding_intersections(mesh, Scalar::float64) == 0);
  CHECK(count_rounding_intersections(tip_above(1e-30), Scalar::float32) == 0);
}
