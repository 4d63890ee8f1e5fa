// Remeshing of CAD-like bodies after cleaning. Rotated boxes with common planes leave slivers
// thinner than a spacing. CGAL counts self-intersections.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "geometry/numbers/predicates.h"
#include "helpers/cgal_oracle.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/clean.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

Mesh centered_box(const Vec3& size) { return cuboid(-0.5 * size, 0.5 * size); }

Mesh turned(Mesh mesh, double angle_deg, Scalar coordinate) {
  const Eigen::AngleAxisd rotation(angle_deg * std::numbers::pi / 180, Vec3(1, 2, 3).normalized());
  for (Vec3& p : mesh.positions) p = rounded_to(rotation * p, coordinate);
  return mesh;
}

/// Remeshes the cleaned union, and checks everything that remesh.h guarantees. Does nothing and
/// returns false if bodies of the union touch each other, which CGAL counts as self-intersections.
bool check_remeshed(const Mesh& overlapping, Scalar coordinate) {
  CleanOptions cleaning;
  cleaning.coordinate = coordinate;
  Mesh mesh = clean(overlapping, cleaning).mesh;
  const double area = surface_area(mesh);
  if (count_self_intersections(mesh) != 0) return false;
  RemeshOptions options;
  options.min_edge = 0.07;
  options.max_edge = 0.15;
  options.feature_angle_deg = 40;
  options.coordinate = coordinate;
  remesh(mesh, options);
  CHECK(count_self_intersections(mesh) == 0);
  CHECK(degenerate_faces(mesh).empty());
  CHECK(is_closed(mesh));
  CHECK(is_oriented_manifold(mesh));
  CHECK(surface_area(mesh) == doctest::Approx(area).epsilon(1e-3));
  return true;
}

}  // namespace

TEST_CASE("boxes that share planes are remeshed without self-intersections at any angle") {
  const Mesh boxes = joined(centered_box({1, 1, 1}), centered_box({1, 0.5, 1}));
  for (const Scalar coordinate : {Scalar::float64, Scalar::float32}) {
    for (const double angle : {0.0, 17.0, 34.0, 51.0, 68.0, 85.0}) {
      CAPTURE(angle);
      CHECK(check_remeshed(turned(boxes, angle, coordinate), coordinate));
    }
  }
}

TEST_CASE("random boxes that touch in planes are remeshed without self-intersections") {
  test::Random random(31);
  int checked = 0;
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const auto side = [&] { return 0.25 * static_cast<double>(1 + random.below(6)); };
    const auto shift = [&] { return 0.25 * static_cast<double>(random.below(3)); };
    Mesh boxes = centered_box({side(), side(), side()});
    for (int k = 0; k < 2; ++k)
      boxes = joined(boxes, moved(centered_box({side(), side(), side()}), {shift(), shift(), 0}));
    const Mesh bodies = turned(boxes, random.uniform(0, 90), Scalar::float64);
    checked += check_remeshed(bodies, Scalar::float64) ? 1 : 0;
  }
  CHECK(checked >= 8);
}

TEST_CASE("a triangle thinner than rounding is split without faces that have no area") {
  // The apex lies half a spacing off the middle of a side that is split many times.
  const Vec3 a(0.1, 0.2, 0.3), b(17.3, 11.9, 7.7);
  const Vec3 middle = 0.5 * a + 0.5 * b;
  Mesh mesh;
  mesh.positions = {
      a, b, {middle.x(), middle.y(), std::nextafter(middle.z(), 100)}, {30, -20, 5}, {-20, 30, 5}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}, {0, 2, 4}, {2, 1, 4}};
  RemeshOptions options;
  options.min_edge = 1;
  options.max_edge = 2.5;
  remesh(mesh, options);
  CHECK(degenerate_faces(mesh).empty());
  CHECK(is_oriented_manifold(mesh));
  CHECK(count_self_intersections(mesh) == 0);
}
