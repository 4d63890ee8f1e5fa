#include "tm/views/wrap/wrap.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "tm/clean/intersect/intersect.h"
#include "tm/geometry/winding.h"
#include "tm/mesh/components.h"
#include "tm/mesh/measure.h"
#include "tm/support/error.h"

using namespace transformesh;

namespace {

struct Cloud {
  std::vector<Vec3> points, normals;
};

/// Evenly spread on a sphere (a golden spiral), a bit off it.
Cloud sphere_cloud(int count, double noise = 0) {
  test::Random random(3);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = 2.399963229728653 * i;
    const double radius = std::sqrt(1 - z * z);
    const Vec3 normal(radius * std::cos(angle), radius * std::sin(angle), z);
    cloud.points.push_back((1 + random.uniform(-noise, noise)) * normal);
    cloud.normals.push_back(normal);
  }
  return cloud;
}

/// Strewn over a torus.
std::vector<Vec3> ring_points(int count) {
  test::Random random(1);
  std::vector<Vec3> ring;
  for (int i = 0; i < count; ++i) {
    const double u = random.uniform(0, 6.2831853);
    const double v = random.uniform(0, 6.2831853);
    const double radius = 1 + 0.3 * std::cos(v);
    ring.emplace_back(radius * std::cos(u), radius * std::sin(u), 0.3 * std::sin(v));
  }
  return ring;
}

void check_surface(const Mesh& mesh) {
  const test::Count count = test::count(mesh);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(find_intersections(mesh).empty());
  CHECK(volume(mesh) > 0);
}

}  // namespace

TEST_CASE("an alpha wrap contains all points, at its offset") {
  const Cloud cloud = sphere_cloud(800);
  const Mesh mesh = alpha_wrap(cloud.points, {.alpha = 0.2, .offset = 0.02}).mesh;
  check_surface(mesh);
  CHECK(connected_components(mesh).components.size() == 1);
  const WindingQuery winding(mesh);
  for (const Vec3& point : cloud.points) CHECK(winding(point).rounded() == 1);
  for (const Vec3& position : mesh.positions) {
    CHECK(position.norm() > 0.95);
    CHECK(position.norm() < 1.03);
  }
}

TEST_CASE("alpha decides what is a hole") {
  // A small ball passes through the ring, a large one does not.
  const std::vector<Vec3> ring = ring_points(3000);
  const Mesh fine = alpha_wrap(ring, {.alpha = 0.25, .offset = 0.02}).mesh;
  check_surface(fine);
  CHECK(connected_components(fine).components[0].genus() == 1);
  const Mesh coarse = alpha_wrap(ring, {.alpha = 1.5, .offset = 0.02}).mesh;
  check_surface(coarse);
  CHECK(connected_components(coarse).components[0].genus() == 0);
}

TEST_CASE("the alpha that is found fits the points: tight, but never in between them") {
  double before = 10;
  for (const int count : {200, 800, 3200, 12800}) {
    CAPTURE(count);
    const AlphaWrap ring = alpha_wrap(ring_points(count));
    check_surface(ring.mesh);
    REQUIRE(connected_components(ring.mesh).components.size() == 1);
    CHECK(connected_components(ring.mesh).components[0].genus() == 1);
    // Pappus: 2 pi^2 R r^2.
    CHECK(volume(ring.mesh) == doctest::Approx(1.7765).epsilon(0.15));
    CHECK(ring.alpha < before);
    before = ring.alpha;
  }
  CHECK(before < 0.15);
}

TEST_CASE("a Poisson surface goes between noisy points, and closes what they leave open") {
  Cloud cloud = sphere_cloud(2000, 0.01);
  const Mesh whole = poisson_wrap(cloud.points, cloud.normals);
  check_surface(whole);
  for (const Vec3& position : whole.positions) CHECK(std::abs(position.norm() - 1) < 0.03);
  CHECK(volume(whole) == doctest::Approx(4.18879).epsilon(0.03));

  // The top is missing.
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

TEST_CASE("an alpha of millions of faces is refused before it takes its time") {
  const Cloud cloud = sphere_cloud(1000);
  for (const double alpha : {0.004, 1e-4, 1e-8}) {
    CAPTURE(alpha);
    CHECK_THROWS_WITH_AS(alpha_wrap(cloud.points, {.alpha = alpha, .offset = 0.1}),
                         doctest::Contains("too small"), UsageError);
  }
  // One ball; and many that are small, each on its own.
  CHECK_THROWS_AS(alpha_wrap(std::vector<Vec3>{Vec3::Zero()}, {.alpha = 1e-4, .offset = 1}),
                  UsageError);
  check_surface(alpha_wrap(cloud.points, {.alpha = 1e-4, .offset = 1e-4}).mesh);
}

namespace {

std::vector<Vec3> scaled(std::vector<Vec3> points, double factor) {
  for (Vec3& point : points) point *= factor;
  return points;
}

}  // namespace

TEST_CASE("scaling the points scales the wrap, up to where squares overflow or vanish") {
  const Cloud cloud = sphere_cloud(300, 0.02);
  const Mesh alpha = alpha_wrap(cloud.points).mesh;
  const Mesh poisson = poisson_wrap(cloud.points, cloud.normals);
  for (const double factor : {0x1p-950, 0x1p-600, 0x1p-300, 0x1p-7, 0x1p7, 0x1p520, 0x1p900}) {
    CAPTURE(factor);
    const std::vector<Vec3> points = scaled(cloud.points, factor);
    const AlphaWrap wrap = alpha_wrap(points);
    CHECK(wrap.mesh.positions == scaled(alpha.positions, factor));
    CHECK(wrap.mesh.faces == alpha.faces);
    CHECK(alpha_wrap(points, {.alpha = wrap.alpha}).mesh.positions == wrap.mesh.positions);
    CHECK(poisson_wrap(points, cloud.normals).positions == scaled(poisson.positions, factor));
  }
}

TEST_CASE("points too far apart, too close, or too far off for their size are refused") {
  const Cloud cloud = sphere_cloud(200);
  for (const double factor : {1e-320, 1e-300, 1e300, 1.7e308}) {
    CAPTURE(factor);
    const std::vector<Vec3> points = scaled(cloud.points, factor);
    CHECK_THROWS_WITH_AS(alpha_wrap(points), doctest::Contains("scale them"), InputError);
    CHECK_THROWS_WITH_AS(poisson_wrap(points, cloud.normals), doctest::Contains("scale them"),
                         InputError);
  }
  for (const double distance : {1e13, 1e30, 1e300}) {
    CAPTURE(distance);
    std::vector<Vec3> points = cloud.points;
    for (Vec3& point : points) point.x() += distance;
    CHECK_THROWS_WITH_AS(alpha_wrap(points), doctest::Contains("to the origin"), InputError);
  }
  CHECK_THROWS_AS(alpha_wrap(cloud.points, {.alpha = 1e300}), InputError);
  CHECK_THROWS_AS(alpha_wrap(cloud.points, {.alpha = 1e-300}), InputError);
  CHECK_THROWS_AS(alpha_wrap(cloud.points, {.offset = 1e-300}), InputError);
}

TEST_CASE("one point, two, and points on a line or in a plane, at any scale") {
  for (const double scale : {1e-300, 1e-154, 1.0, 1e154, 1e300}) {
    const std::vector<Vec3> one(3, Vec3(scale, scale, scale));
    const std::vector<Vec3> two = {{scale, 0, 0}, {0, scale, 0}};
    std::vector<Vec3> line, plane;
    for (int i = 0; i < 30; ++i) {
      line.emplace_back(scale * i, scale * i / 2, 0);
      plane.emplace_back(scale * (i % 6), scale * (i % 5), 0);
    }
    for (const std::vector<Vec3>& points : {one, two, line, plane}) {
      CAPTURE(scale);
      CAPTURE(points.size());
      const bool is_refused = scale == 1e-300 || scale == 1e300 || points[0] == points[1];
      if (is_refused) {
        CHECK_THROWS_AS(alpha_wrap(points), InputError);
      } else {
        CHECK(test::count(alpha_wrap(points).mesh).is_closed_and_oriented);
      }
      CHECK_THROWS_AS(poisson_wrap(points, std::vector<Vec3>(points.size(), Vec3::UnitZ())),
                      InputError);
    }
  }
}

TEST_CASE("normals that point inwards are refused") {
  Cloud cloud = sphere_cloud(500);
  for (Vec3& normal : cloud.normals) normal = -normal;
  CHECK_THROWS_WITH_AS(poisson_wrap(cloud.points, cloud.normals), doctest::Contains("inwards"),
                       GoalError);
}

TEST_CASE("the same bytes each time") {
  const Cloud cloud = sphere_cloud(300, 0.02);
  const Mesh first = poisson_wrap(cloud.points, cloud.normals);
  const Mesh second = poisson_wrap(cloud.points, cloud.normals);
  CHECK(first.positions == second.positions);
  CHECK(first.faces == second.faces);
  CHECK(alpha_wrap(cloud.points).mesh.positions == alpha_wrap(cloud.points).mesh.positions);
}

TEST_CASE("too few points, points in a plane and senseless options are refused") {
  const std::vector<Vec3> none;
  CHECK_THROWS_AS(alpha_wrap(none), InputError);
  const std::vector<Vec3> one = {{1, 2, 3}};
  CHECK_THROWS_AS(alpha_wrap(one), InputError);
  check_surface(alpha_wrap(one, {.alpha = 0.2, .offset = 0.1}).mesh);
  CHECK_THROWS_AS(alpha_wrap(one, {.alpha = -1}), UsageError);

  const std::vector<Vec3> three(3, Vec3::UnitX());
  CHECK_THROWS_AS(poisson_wrap(three, three), InputError);
  std::vector<Vec3> plane, up;
  for (int i = 0; i < 25; ++i) {
    plane.emplace_back(i % 5, i / 5, 1);
    up.push_back(Vec3::UnitZ());
  }
  CHECK_THROWS_AS(poisson_wrap(plane, up), InputError);
  CHECK_THROWS_AS(poisson_wrap(plane, std::vector<Vec3>(25, Vec3::Zero())), InputError);
  check_surface(alpha_wrap(plane, {.alpha = 2, .offset = 0.1}).mesh);
}
