#include <doctest/doctest.h>

#include "helpers/point_clouds.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/wrap.h"

using namespace transformesh;
using namespace transformesh::test;

TEST_CASE("a Poisson surface passes between noisy points, and closes holes") {
  Cloud cloud = sphere_cloud(2000, 0.01);
  const Mesh whole = poisson_wrap(cloud.points, cloud.normals);
  check_surface(whole);
  for (const Vec3& position : whole.positions) CHECK(std::abs(position.norm() - 1) < 0.03);
  CHECK(volume(whole) == doctest::Approx(4.18879).epsilon(0.03));

  // The top of the sphere is missing.
  Cloud open;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (cloud.points[i].z() > 0.8) continue;
    open.points.push_back(cloud.points[i]);
    open.normals.push_back(cloud.normals[i]);
  }
  const Mesh closed = poisson_wrap(open.points, open.normals);
  check_surface(closed);
  CHECK(volume(closed) == doctest::Approx(4.18879).epsilon(0.1));
}

TEST_CASE("points exactly on a sphere have a Poisson surface, and normals inwards still none") {
  for (const int count : {50, 100, 200, 500, 1000, 2000}) {
    CAPTURE(count);
    Cloud cloud = sphere_cloud(count);
    const Mesh mesh = poisson_wrap(cloud.points, cloud.normals);
    check_surface(mesh);
    CHECK(connected_components(mesh).components.size() == 1);
    for (const Vec3& position : mesh.positions) CHECK(std::abs(position.norm() - 1) < 0.1);
    for (Vec3& normal : cloud.normals) normal = -normal;
    CHECK_THROWS_AS(poisson_wrap(cloud.points, cloud.normals), GoalError);
  }
}

TEST_CASE("normals that point inwards are refused") {
  Cloud cloud = sphere_cloud(500);
  for (Vec3& normal : cloud.normals) normal = -normal;
  CHECK_THROWS_WITH_AS(poisson_wrap(cloud.points, cloud.normals), doctest::Contains("inwards"),
                       GoalError);
}

TEST_CASE("points without a normal are left out, too few and those in a plane are refused") {
  Cloud cloud = sphere_cloud(500, 0.01);
  const Mesh mesh = poisson_wrap(cloud.points, cloud.normals);
  cloud.points.emplace_back(9, 9, 9);
  cloud.normals.push_back(Vec3::Zero());
  CHECK(poisson_wrap(cloud.points, cloud.normals).positions == mesh.positions);

  const std::vector<Vec3> three(3, Vec3::UnitX());
  CHECK_THROWS_AS(poisson_wrap(three, three), InputError);
  std::vector<Vec3> plane, up;
  for (int i = 0; i < 25; ++i) {
    plane.emplace_back(i % 5, i / 5, 1);
    up.push_back(Vec3::UnitZ());
  }
  CHECK_THROWS_AS(poisson_wrap(plane, up), InputError);
  CHECK_THROWS_AS(poisson_wrap(plane, std::vector<Vec3>(25, Vec3::Zero())), InputError);
}
