#include "mesh/coordinate_spacing.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace transformesh;

namespace {

Mesh tetrahedron(const Vec3& corner) {
  Mesh mesh;
  mesh.positions = {corner, corner + Vec3::UnitX(), corner + Vec3::UnitY(), corner + Vec3::UnitZ()};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

}  // namespace

TEST_CASE("the spacing of doubles at the largest coordinate") {
  CHECK(coordinate_spacing(tetrahedron({0, 0, 0})) == 0x1p-52);
  CHECK(coordinate_spacing(tetrahedron({-0x1p60, 0, 0})) == 0x1p8);
  const double largest = std::numeric_limits<double>::max();
  CHECK(coordinate_spacing(tetrahedron({largest, 0, 0})) ==
        std::numeric_limits<double>::infinity());
  CHECK(coordinate_spacing({}) == std::numeric_limits<double>::denorm_min());
}

TEST_CASE("the spacing of floats") {
  for (const float size : {1.0F, 1.5F, 3e30F, 1e-30F}) {
    const double next = std::nextafter(size, 2 * size);
    CHECK(spacing_at(-size, Scalar::float32) == next - size);
    CHECK(spacing_at(size) == std::nextafter(double{size}, 1e99) - size);
  }
}

TEST_CASE("faces collapse where two corners become one place, and turn where a body becomes flat") {
  const auto loss = [](const Vec3& corner) {
    return rounding_loss(tetrahedron(corner), tetrahedron({0, 0, 0}).positions);
  };
  CHECK(loss({0, 0, 0}).collapsed == 0);
  CHECK(loss({0, 0, 0}).turned == 0);
  CHECK(loss({0x1p51, 0, 0}).collapsed == 0);
  CHECK(loss({0x1p51, 0, 0}).turned == 0);
  // The edge along x collapses with two faces; of the other two, the oblique face turns over.
  CHECK(loss({0x1p60, 0, 0}).collapsed == 2);
  CHECK(loss({0x1p60, 0, 0}).turned == 1);
  CHECK(loss({0x1p60, 0x1p60, 0x1p60}).collapsed == 4);
  // A face that had no area before is not counted.
  Mesh flat = tetrahedron({0, 0, 0});
  flat.faces = {{0, 0, 1}, {1, 1, 1}};
  CHECK(rounding_loss(flat, flat.positions).collapsed == 0);
}
