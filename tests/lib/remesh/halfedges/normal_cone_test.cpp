#include "remesh/halfedges/normal_cone.h"

#include <bit>
#include <vector>

#include "helpers/random.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// Counts the directions to the sides, edges and corners of a cube that have a cosine above
/// `cosine` to the normal.
int count_within(const Vec3& normal, double cosine) {
  int count = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Vec3 direction = Vec3(x, y, z).normalized();
        count += direction.dot(normal.normalized()) > cosine;
      }
  return count;
}

NormalCone cone_of(const Vec3& normal) { return common_cone(std::span(&normal, 1)); }

}  // namespace

TEST_CASE("a normal is in the cones of directions within 88 degrees") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 normal = random.point(-1, 1) * std::pow(10, random.uniform(-28, 28));
    const int seen = std::popcount(cone_of(normal));
    CHECK(seen <= count_within(normal, 0.02999));
    CHECK(seen >= count_within(normal, 0.03001));
  }
}

TEST_CASE("opposite normals share no direction, similar normals mostly do") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3 normal = random.point(-1, 1);
    CHECK((cone_of(normal) & cone_of(-normal)) == 0);
    const Vec3 near = normal + random.point(-0.2, 0.2) * normal.norm();
    CHECK((cone_of(normal) & cone_of(near)) != 0);
  }
}

TEST_CASE("zero vectors, and those beyond single precision, are in no cone") {
  CHECK(cone_of(Vec3::Zero()) == 0);
  CHECK(cone_of(Vec3(1e-40, 0, 0)) == 0);
  CHECK(cone_of(Vec3(1e40, 1e40, 0)) == 0);
  CHECK((cone_of(Vec3(1, 2, 3)) & ~all_directions) == 0);
}

TEST_CASE("cones of several normals are the intersections of their cones") {
  Random random(4);
  for (std::size_t count = 0; count <= 11; ++count) {
    for (int round = 0; round < 50; ++round) {
      const Vec3 middle = random.point(-1, 1);
      std::vector<Vec3> normals(count);
      for (Vec3& normal : normals)
        normal = (middle + random.point(-0.3, 0.3)) * std::pow(10, random.uniform(-28, 28));
      if (count > 0 && round == 0) normals[count / 2] = Vec3(1e-40, 0, 0);
      std::vector<NormalCone> cones(count);
      find_cones(normals, cones);
      NormalCone common = all_directions;
      for (std::size_t i = 0; i < count; ++i) {
        REQUIRE(cones[i] == cone_of(normals[i]));
        common &= cones[i];
      }
      REQUIRE(common_cone(normals) == common);
      std::vector<NormalPair> pairs((count + 1) / 2);
      for (std::size_t i = 0; i < count; ++i) {
        NormalPair& pair = pairs[i / 2];
        pair.normal.x[i % 2] = normals[i].x();
        pair.normal.y[i % 2] = normals[i].y();
        pair.normal.z[i % 2] = normals[i].z();
        pair.squared[i % 2] = normals[i].squaredNorm();
      }
      REQUIRE(common_cone(pairs, count) == common);
    }
  }
}

TEST_CASE("a direction is in front of a triangle, not behind it or along it") {
  const Triangle triangle{Vec3(0, 0, 5), Vec3(1, 0, 5), Vec3(0, 1, 5)};
  CHECK(sees(Vec3(0, 0, 1), triangle));
  CHECK(sees(Vec3(0.99, 0, 0.1).normalized(), triangle));
  CHECK_FALSE(sees(Vec3(0, 0, -1), triangle));
  CHECK_FALSE(sees(Vec3(1, 0, 0.01).normalized(), triangle));
}

TEST_CASE("the nearest direction of a cone is found") {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const Vec3 vector = random.point(-1, 1) * std::pow(10, random.uniform(-200, 200));
    const NormalCone cone = cone_of(random.point(-1, 1));
    if (cone == 0) continue;
    const Direction nearest = nearest_direction(cone, vector);
    CHECK((nearest.bit & cone) == nearest.bit);
    CHECK((cone_of(nearest.unit) & nearest.bit) != 0);
    CHECK(nearest.unit.norm() == doctest::Approx(1));

    // No other direction of the cone has a larger cosine. A cone with one direction gives that
    // direction.
    for (NormalCone rest = cone; rest != 0; rest &= rest - 1) {
      const Direction other = nearest_direction(rest & -rest, vector);
      CHECK(other.bit == (rest & -rest));
      CHECK(other.unit.dot(vector) <= nearest.unit.dot(vector) + 1e-6 * vector.norm());
    }
  }
}
