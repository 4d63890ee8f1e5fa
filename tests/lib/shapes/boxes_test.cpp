#include "shapes/boxes.h"

#include <doctest/doctest.h>

#include "helpers/mesh_facts.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("a box has its corners, its volume and the cells that its faces are enough for") {
  const Mesh least = shapes::box({2, 4, 6}, 1);
  CHECK(least.positions.size() == 8);
  CHECK(least.faces.size() == 12);
  CHECK(signed_volume(least) == 48);

  // Cells of edge 1 make 2 (2 * 4 + 4 * 6 + 6 * 2) squares of two faces.
  const Mesh fine = shapes::box({2, 4, 6}, 176);
  CHECK(fine.faces.size() == 176);
  CHECK(fine.positions.size() == 176 / 2 + 2);
  CHECK(signed_volume(fine) == doctest::Approx(48).epsilon(1e-14));
  CHECK(count(fine).genera == std::vector<long>{0});
  for (const Vec3& point : fine.positions) {
    const Vec3 share = point.cwiseQuotient(Vec3(1, 2, 3)).cwiseAbs();
    CHECK(share.maxCoeff() == 1);
  }
}

TEST_CASE("boxes have integer corners within the world, and edges of 1 to 4") {
  const Mesh mesh = shapes::boxes(27, 3);
  REQUIRE(mesh.faces.size() == 27 * 12);
  const double world = 4 + 2 * 3;
  for (const Vec3& point : mesh.positions) {
    CHECK(point == point.array().round().matrix());
    CHECK(point.minCoeff() >= 0);
    CHECK(point.maxCoeff() <= world);
  }
  for (std::size_t i = 0; i < 27; ++i) {
    Mesh single;
    single.positions.assign(mesh.positions.begin() + 8 * i, mesh.positions.begin() + 8 * i + 8);
    Vec3 low = single.positions[0];
    Vec3 high = low;
    for (const Vec3& point : single.positions) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    CHECK((high - low).minCoeff() >= 1);
    CHECK((high - low).maxCoeff() <= 4);
  }
  CHECK(shapes::boxes(27, 3).positions == mesh.positions);
  CHECK(shapes::boxes(27, 4).positions != mesh.positions);
}
