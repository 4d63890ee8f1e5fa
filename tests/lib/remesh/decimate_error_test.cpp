/// Decimation within an error, judged by dense samples against all faces (sampled_distance.h).
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "helpers/random.h"
#include "helpers/sampled_distance.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/decimate.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

constexpr int sample_steps = 8;

Mesh with_noise(Mesh mesh, double length, test::Random& random) {
  for (Vec3& p : mesh.positions) p += random.point(-length, length);
  return mesh;
}

Mesh stretched(Mesh mesh, const Vec3& factors) {
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(factors);
  return mesh;
}

/// A wavy sheet with a border.
Mesh waves(int steps, double height) {
  Mesh mesh = test::grid(steps);
  for (Vec3& p : mesh.positions) p.z() = height * std::sin(9 * p.x()) * std::cos(7 * p.y());
  return mesh;
}

/// Two balls that almost touch.
Mesh neighbors() {
  return test::joined(test::icosphere(2), test::moved(test::icosphere(2), {2.05, 0, 0}));
}

std::vector<Mesh> shapes(test::Random& random) {
  const Mesh ball = test::icosphere(3), ring = test::torus(1, 0.4, 36, 18);
  return {with_noise(ball, 0.03, random),
          ball,
          with_noise(ring, 0.02, random),
          stretched(ball, {1, 1, 0.02}),
          stretched(ball, {20, 1, 1}),
          stretched(ring, {1, 0.1, 1}),
          waves(20, 0.1),
          with_noise(test::grid(20), 0.01, random),
          neighbors(),
          stretched(waves(20, 0.3), {5, 0.05, 1})};
}

/// Rotates the mesh about a random axis, and moves it.
Mesh placed(Mesh mesh, test::Random& random) {
  const Eigen::AngleAxisd turn(random.uniform(0, 3), random.point(-1, 1).normalized());
  const Vec3 place = random.point(-3, 3);
  for (Vec3& p : mesh.positions) p = turn * p + place;
  return mesh;
}

double hausdorff(const Mesh& first, const Mesh& second) {
  return std::max(test::sampled_distance(first, second, sample_steps),
                  test::sampled_distance(second, first, sample_steps));
}

/// Returns the sampled distance as a fraction of the error.
double check_within(const Mesh& input, double error) {
  Mesh mesh = input;
  DecimateOptions options;
  options.error = error;
  const DecimateResult result = decimate(mesh, options);
  const double distance = hausdorff(input, mesh);
  CAPTURE(error);
  CAPTURE(input.faces.size());
  CAPTURE(mesh.faces.size());
  CHECK(distance <= error);
  CHECK(distance <= result.error_bound);
  CHECK(result.error_bound <= error);
  CHECK(result.faces == mesh.faces.size());
  CHECK(test::is_oriented_manifold(mesh));
  CHECK(find_intersections(mesh).size() <= find_intersections(input).size());
  return distance / error;
}

int rounds() {
  const char* wanted = std::getenv("TM_ROUNDS");
  return wanted != nullptr ? std::atoi(wanted) : 1;
}

}  // namespace

TEST_CASE("the error of decimation is not exceeded: 10 meshes, TM_ROUNDS=30 for 300") {
  double largest = 0;
  for (int round = 0; round < rounds(); ++round) {
    CAPTURE(round);
    test::Random random(static_cast<std::uint64_t>(round));
    for (const Mesh& shape : shapes(random)) {
      const Mesh mesh = placed(shape, random);
      largest = std::max(largest, check_within(mesh, 0.3 * std::pow(10, random.uniform(-3, 0))));
    }
  }
  // The error is nearly reached; otherwise the test would not notice if it were exceeded.
  CHECK(largest > 0.9);
}

TEST_CASE("an error without a number of faces leaves few faces") {
  // Let the corners of an equilateral triangle with edges s be on the unit sphere. The midpoints of
  // its edges are s^2 / 8 inside the sphere, and its center is s^2 / 6 inside.
  Mesh ball = test::icosphere(4);
  DecimateOptions options;
  options.error = 0.01;
  decimate(ball, options);
  // The error 0.01 allows s^2 = 0.06. Each face then has the area sqrt(3) / 4 s^2, and 484 faces
  // cover the sphere. Fewer faces suffice if they extend to both sides of the sphere.
  CHECK(ball.faces.size() < 484);
  CHECK(ball.faces.size() > 100);
}

TEST_CASE("with both, the number of faces is reached or the error stops it") {
  const Mesh ball = test::icosphere(4);
  DecimateOptions options;
  options.error = 0.05;
  options.faces = 1000;
  Mesh mesh = ball;
  CHECK(decimate(mesh, options).faces == 1000);
  options.faces = 8;
  mesh = ball;
  const DecimateResult result = decimate(mesh, options);
  CHECK(result.faces > 8);
  CHECK(result.error_refused > 0);
  CHECK(hausdorff(ball, mesh) <= 0.05);
}

TEST_CASE("an error of 0 merges flat faces, closed or with a border, and moves nothing else") {
  DecimateOptions options;
  options.error = 0;
  Mesh sheet = test::grid(12);
  const DecimateResult result = decimate(sheet, options);
  CHECK(sheet.faces.size() == 2);
  CHECK(result.merged_faces == 286);
  CHECK(result.error_bound < 1e-14);
  Mesh ball = test::icosphere(2);
  CHECK(decimate(ball, options).faces == test::icosphere(2).faces.size());
}

TEST_CASE("flat faces are merged even if that leaves fewer faces than wanted") {
  DecimateOptions options;
  options.error = 1e-6;
  options.faces = 100;
  Mesh sheet = test::grid(12);
  const DecimateResult result = decimate(sheet, options);
  CHECK(result.faces == 2);
  CHECK(result.merged_faces == 286);
  CHECK(surface_area(sheet) == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("borders that are kept stay, within the error elsewhere") {
  const Mesh input = waves(20, 0.1);
  DecimateOptions options;
  options.error = 0.02;
  options.keep_border = true;
  Mesh mesh = input;
  decimate(mesh, options);
  CHECK(mesh.faces.size() < input.faces.size() / 2);
  std::size_t on_border = 0;
  for (const Vec3& p : mesh.positions)
    on_border += p.x() == 0 || p.x() == 1 || p.y() == 0 || p.y() == 1;
  CHECK(on_border == 80);
  CHECK(hausdorff(input, mesh) <= 0.02);
  options.error = 0;
  CHECK_THROWS_AS(decimate(mesh, options), UsageError);
}

TEST_CASE("errors that are no distances are refused, and extreme ones are not exceeded") {
  Mesh ball = test::icosphere(2);
  DecimateOptions options;
  for (const double error : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    options.error = error;
    CHECK_THROWS_AS(decimate(ball, options), UsageError);
  }
  options.error = 1e-300;
  CHECK(decimate(ball, options).collapses == 0);
  options.error = 1e300;
  CHECK(decimate(ball, options).faces == 4);
}

TEST_CASE("positions rounded to floats keep the error") {
  const Mesh input = test::moved(test::icosphere(3), {1000, 0, 0});
  Mesh rounded = input;
  for (Vec3& p : rounded.positions) p = p.cast<float>().cast<double>();
  DecimateOptions options;
  options.coordinate = Scalar::float32;
  options.error = 0.01;
  Mesh mesh = rounded;
  decimate(mesh, options);
  for (const Vec3& p : mesh.positions) CHECK(p == Vec3(p.cast<float>().cast<double>()));
  CHECK(mesh.faces.size() < rounded.faces.size() / 2);
  CHECK(hausdorff(rounded, mesh) <= 0.01);
}
