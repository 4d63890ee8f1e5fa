#include "transformesh/compare.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "geometry/search/closest_point.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("a mesh has distance 0 from itself") {
  const Mesh mesh = test::torus(2, 0.5, 40, 20);
  const Comparison same = compare(mesh, mesh);
  CHECK(same.accuracy < 1e-15);
  CHECK(same.completeness == 1);
  CHECK(same.hausdorff < 1e-15);
  CHECK(same.volume_difference == 0);
}

TEST_CASE("a square above a square is at its height everywhere") {
  const Mesh low = test::grid(5);
  const Mesh high = test::moved(test::grid(8), {0, 0, 0.25});
  const Comparison found = compare(high, low, {.samples = 1000, .seed = 4, .distance = 0.24});
  CHECK(found.accuracy == Approx(0.25));
  CHECK(found.completeness == 0);
  CHECK(found.mean == Approx(0.25));
  CHECK(found.rms == Approx(0.25));
  CHECK(found.hausdorff == Approx(0.25));
  CHECK(compare(high, low, {.samples = 1000, .seed = 4, .distance = 0.26}).completeness == 1);
}

TEST_CASE("the distances of a half and the whole differ in the two directions") {
  // The half square x < 1/2 is a part of the unit square, the reference. Points of the unit square
  // are max(0, x - 1/2) away from the half square.
  Mesh half = test::grid(4);
  for (Vec3& point : half.positions) point.x() /= 2;
  const Comparison found = compare(half, test::grid(4), {.samples = 40000, .distance = 0.1});
  CHECK(found.accuracy < 1e-12);
  CHECK(found.hausdorff_to_reference < 1e-12);
  CHECK(found.hausdorff_from_reference == Approx(0.5));
  CHECK(found.hausdorff == found.hausdorff_from_reference);
  CHECK(found.completeness == Approx(0.6).epsilon(0.005));
  CHECK(found.mean == Approx(0.125 / 2).epsilon(0.005));
  CHECK(found.rms == Approx(std::sqrt(1.0 / 24 / 2)).epsilon(0.005));

  // If the half square is the reference, the accuracy is the 90 % quantile of max(0, x - 1/2) over
  // the unit square. The quantile is at x = 0.9.
  const Comparison turned = compare(test::grid(4), half, {.samples = 40000, .distance = 1e-12});
  CHECK(turned.accuracy == Approx(0.4).epsilon(0.005));
  CHECK(turned.completeness == 1);
}

TEST_CASE("concentric spheres differ by their radii and volumes") {
  const Mesh small = test::icosphere(5);
  const Mesh large = test::scaled(test::icosphere(5), 1.1);
  const Comparison found = compare(large, small, {.samples = 20000});
  CHECK(found.mean == Approx(0.1).epsilon(0.01));
  CHECK(found.hausdorff == Approx(0.1).epsilon(0.02));
  CHECK(found.volume_difference == Approx(4 * std::numbers::pi / 3 * (1.331 - 1)).epsilon(0.005));
}

TEST_CASE("the default distance is 1 % of the reference's diagonal") {
  const Mesh reference = test::grid(3);
  const double diagonal = std::sqrt(2.0);
  CHECK(compare(test::moved(reference, {0, 0, 0.0099 * diagonal}), reference).completeness == 1);
  CHECK(compare(test::moved(reference, {0, 0, 0.0101 * diagonal}), reference).completeness == 0);
}

TEST_CASE("points stand for themselves") {
  Mesh points;
  points.positions = {{0, 0, 0}, {3, 4, 0}};
  Mesh origin;
  origin.positions = {{0, 0, 0}};
  const Comparison found = compare(points, origin);
  CHECK(found.hausdorff_to_reference == 5);
  CHECK(found.hausdorff_from_reference == 0);
  CHECK(found.mean == 1.25);
  CHECK(found.completeness == 1);
  CHECK(found.volume_difference == 0);
  CHECK_THROWS_AS(compare(Mesh{}, origin), InputError);
  CHECK_THROWS_AS(compare(origin, Mesh{}), InputError);
}

TEST_CASE("vertices that no face uses do not count") {
  Mesh mesh = test::cube();
  mesh.positions.emplace_back(100, 0, 0);
  CHECK(compare(mesh, test::cube()).hausdorff < 1e-15);
}

TEST_CASE("the comparison is the same for any number of threads") {
  const Mesh a = test::icosphere(3);
  const Mesh b = test::torus(0.8, 0.3, 30, 12);
  std::vector<Comparison> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.push_back(compare(a, b, {.samples = 5000}));
  }
  for (const Comparison& result : results) {
    CHECK(result.mean == results[0].mean);
    CHECK(result.rms == results[0].rms);
    CHECK(result.hausdorff == results[0].hausdorff);
  }
  CHECK_THROWS_AS(compare(a, b, {}, Progress([](auto, double) { return false; })), CancelledError);
}

TEST_CASE("meshes too large to compare are refused") {
  const Mesh mesh = test::icosphere(1);
  CHECK_THROWS_AS(compare(test::scaled(mesh, 1e100), mesh), InputError);
  CHECK_THROWS_AS(compare(mesh, test::moved(mesh, {1e200, 0, 0})), InputError);
  CHECK(std::isfinite(compare(test::scaled(mesh, 1e70), mesh, {.samples = 10}).rms));
}

TEST_CASE("meshes too small to compare are refused, and those just above the limit are right") {
  const Mesh mesh = test::icosphere(4);
  const Mesh moved = test::moved(mesh, {0.1, 0, 0});
  const auto scaled_comparison = [&](double factor) {
    return compare(test::scaled(mesh, factor), test::scaled(moved, factor), {.samples = 100});
  };
  for (const double factor : {1e-76, 1e-78, 1e-100, 1e-200})
    CHECK_THROWS_AS(scaled_comparison(factor), InputError);
  const double usual = scaled_comparison(1).hausdorff;
  CHECK(scaled_comparison(1e-75).hausdorff == Approx(usual * 1e-75).epsilon(1e-9));
  // Points at one place have no extent, and are compared.
  Mesh point;
  point.positions = {{1, 2, 3}};
  CHECK(compare(point, point).hausdorff == 0);
}

TEST_CASE("the farthest point is as far as compare() finds it, and lies there") {
  const Mesh sphere = test::icosphere(3);
  for (const Mesh& mesh : {test::torus(1, 0.4, 40, 20), test::moved(sphere, Vec3(0.1, 0, 3)),
                           test::scaled(sphere, 1.01), sphere}) {
    const CompareOptions options{.samples = 5000};
    const Comparison found = compare(mesh, sphere, options);
    const Farthest there = farthest_from(ClosestPointQuery(sphere), mesh, options);
    const Farthest back = farthest_from(ClosestPointQuery(mesh), sphere, options);
    CHECK(there.distance == found.hausdorff_to_reference);
    CHECK(back.distance == found.hausdorff_from_reference);
    CHECK(ClosestPointQuery(sphere)(there.point).distance == there.distance);
  }
}

TEST_CASE("signed distances from a reference that is inside out are refused") {
  const Mesh ball = test::icosphere(2);
  Mesh reversed = ball;
  for (Face& face : reversed.faces) std::swap(face[1], face[2]);
  CHECK(signed_vertex_distances(ball, ball)[0] == 0);
  CHECK_THROWS_AS(signed_vertex_distances(ball, reversed), InputError);
}

TEST_CASE("distances of vertices are those of a search over all faces") {
  const Mesh mesh = test::torus(2, 0.5, 30, 15);
  const Mesh reference = test::moved(test::icosphere(2), {0.7, 0.2, 0.1});
  const std::vector<double> found = vertex_distances(mesh, reference);
  REQUIRE(found.size() == mesh.positions.size());
  for (std::size_t v = 0; v < found.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    double nearest = HUGE_VAL;
    for (const Face& face : reference.faces) {
      const Vec3 closest =
          closest_point_of_triangle(p, reference.positions[face[0]], reference.positions[face[1]],
                                    reference.positions[face[2]])
              .point;
      nearest = std::min(nearest, (p - closest).norm());
    }
    CHECK(found[v] == Approx(nearest));
  }
  CHECK_THROWS_AS(vertex_distances(mesh, Mesh()), InputError);
}
