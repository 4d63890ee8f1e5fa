#include "transformesh/sample.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/search/closest_point.h"
#include "geometry/surface_samples.h"
#include "helpers/shapes.h"
#include "mesh/triangle.h"
#include "support/random.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

namespace {

Vec3 normal_at(const Mesh& points, std::size_t i) {
  const Columns& columns = points.vertex_columns;
  return {columns.find("nx")->values[i], columns.find("ny")->values[i],
          columns.find("nz")->values[i]};
}

double nearest_other(const Mesh& points, std::size_t i) {
  double nearest = HUGE_VAL;
  for (std::size_t j = 0; j < points.positions.size(); ++j)
    if (j != i) nearest = std::min(nearest, (points.positions[i] - points.positions[j]).norm());
  return nearest;
}

double distance_from(const Mesh& points, const Vec3& place) {
  double nearest = HUGE_VAL;
  for (const Vec3& p : points.positions) nearest = std::min(nearest, (place - p).squaredNorm());
  return std::sqrt(nearest);
}

/// Returns the largest distance found from the place by random steps of decreasing length within
/// its face.
double farthest_around(const Mesh& mesh, const Mesh& points, SurfacePoint place) {
  test::Random random(5);
  double farthest = distance_from(points, place.position);
  for (double step = 0.1; step > 1e-8; step *= 0.8)
    for (int i = 0; i < 8; ++i) {
      Vec3 w = place.weights;
      for (int k = 0; k < 3; ++k) w[k] = std::max(0.0, w[k] + step * random.uniform(-1, 1));
      w /= w.sum();
      const Triangle corners = triangle_of(mesh, place.face);
      const Vec3 there = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
      const double distance = distance_from(points, there);
      if (distance <= farthest) continue;
      farthest = distance;
      place = {place.face, w, there};
    }
  return farthest;
}

/// Returns the largest distance of the surface from the points, by brute force.
double farthest_place(const Mesh& mesh, const Mesh& points) {
  std::vector<std::pair<double, std::size_t>> places;
  const std::vector<SurfacePoint> samples = surface_points(mesh, 20000, 77);
  for (std::size_t i = 0; i < samples.size(); ++i)
    places.emplace_back(-distance_from(points, samples[i].position), i);
  std::ranges::sort(places);
  double farthest = 0;
  for (std::size_t i = 0; i < 40; ++i)
    farthest = std::max(farthest, farthest_around(mesh, points, samples[places[i].second]));
  return farthest;
}

}  // namespace

TEST_CASE("points by area are even: chi-square over faces of very different sizes") {
  const Mesh mesh = test::torus(2, 1.2, 20, 12);
  Mesh numbered = mesh;
  Column& ids = numbered.face_columns.get("id", Scalar::int32, mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) ids.values[f] = static_cast<double>(f);
  const std::size_t count = 20000;
  const Mesh points = sample_surface(numbered, {.count = count, .distance = 0, .seed = 5});
  REQUIRE(points.positions.size() == count);
  CHECK(points.faces.empty());

  std::vector<double> found(mesh.faces.size(), 0);
  for (const double id : points.vertex_columns.find("id")->values)
    ++found[static_cast<std::size_t>(id)];
  double chi_square = 0;
  for (std::size_t f = 0; f < found.size(); ++f) {
    const double expected = count * face_area(mesh, static_cast<Index>(f)) / surface_area(mesh);
    chi_square += (found[f] - expected) * (found[f] - expected) / expected;
  }
  // The sum for independent points has 479 degrees of freedom, the mean 479 and the standard
  // deviation 31. The tested points are more even than independent points.
  CHECK(chi_square < 479 + 4 * 31);
}

TEST_CASE("points lie on the faces that their normals and columns are of") {
  Mesh mesh = test::icosphere(4);
  Column& x = mesh.vertex_columns.get("h", Scalar::float64, mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    x.values[v] = mesh.positions[v].dot(Vec3(1, 2, 3));
  const ClosestPointQuery closest(mesh);
  for (const SampleOptions& options : {SampleOptions{2000, 0, 1}, SampleOptions{0, 0.1, 1}}) {
    const Mesh points = sample_surface(mesh, options);
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
      const Vec3& p = points.positions[i];
      CHECK(closest(p).distance < 1e-12);
      CHECK(normal_at(points, i).norm() == Approx(1));
      CHECK(normal_at(points, i).dot(p.normalized()) > std::cos(0.06));
      CHECK(points.vertex_columns.find("h")->values[i] == Approx(p.dot(Vec3(1, 2, 3))));
    }
  }
}

TEST_CASE("Poisson disk samples keep their distance and leave no gap, by brute force") {
  for (const Mesh& mesh : {test::icosphere(3), test::cube(), test::torus(2, 0.5, 40, 20)})
    for (const double distance : {0.12, 0.5, 100.0}) {
      const Mesh points = sample_surface(mesh, {.count = 0, .distance = distance, .seed = 3});
      REQUIRE(!points.positions.empty());
      double nearest = HUGE_VAL;
      for (std::size_t i = 0; i < points.positions.size(); ++i)
        nearest = std::min(nearest, nearest_other(points, i));
      CHECK(nearest >= distance);
      CHECK(farthest_place(mesh, points) <= (1 + 1e-8) * distance);
    }
}

TEST_CASE("a Poisson disk is as dense as random ones that are complete, far from the origin too") {
  // Disks of half the distance cover .547 of a plane (Feder 1980), and more along the edges of a
  // cube.
  for (const double far : {0.0, 1e9}) {
    Mesh mesh = test::cube();
    for (Vec3& p : mesh.positions) p += Vec3(-far, far, 0);
    const double distance = 0.02;
    const Mesh points = sample_surface(mesh, {.count = 0, .distance = distance, .seed = 3});
    const double disks = static_cast<double>(points.positions.size()) * std::numbers::pi / 4;
    const double covered = disks * distance * distance / surface_area(mesh);
    CHECK(covered > 0.547);
    CHECK(covered < 0.58);
  }
}

TEST_CASE("Poisson disk sampling ends if coordinates are as far apart as its points") {
  Mesh mesh = test::scaled(test::cube(), 10);
  for (Vec3& p : mesh.positions) p += Vec3::Constant(1e15);
  const Mesh points = sample_surface(mesh, {.count = 0, .distance = 0.5, .seed = 3});
  CHECK(points.positions.size() > 100);
}

TEST_CASE("samples depend on the seed, and meshes without area are refused") {
  const Mesh mesh = test::cube();
  const auto first = [&](const SampleOptions& options) {
    return sample_surface(mesh, options).positions;
  };
  CHECK(first({100, 0, 1}) == first({100, 0, 1}));
  CHECK(first({100, 0, 1}) != first({100, 0, 2}));
  CHECK(first({0, 0.2, 1}) == first({0, 0.2, 1}));
  CHECK(first({0, 0.2, 1}) != first({0, 0.2, 2}));
  CHECK_THROWS_AS(first({0, 0, 1}), UsageError);
  CHECK_THROWS_AS(first({1, 1, 1}), UsageError);
  CHECK_THROWS_AS(first({0, 1e-9, 1}), UsageError);
  CHECK_THROWS_AS(sample_surface(Mesh(), {1, 0, 1}), InputError);
  Mesh flat = test::cube();
  for (Vec3& p : flat.positions) p = Vec3(1, 2, 3);
  CHECK_THROWS_AS(sample_surface(flat, {1, 0, 1}), InputError);
  CHECK_THROWS_AS(sample_surface(test::scaled(mesh, 1e200), {1, 0, 1}), InputError);
}
