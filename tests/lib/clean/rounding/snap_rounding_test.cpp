/// Results as stored, in cases that are difficult to round. Coplanar faces of rotated lattice boxes
/// are coplanar only up to rounding; other shapes are tiny, huge or far from the origin.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/numbers/predicates.h"
#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/clean.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

Mesh boxes(std::uint64_t seed, std::size_t faces) {
  ShapeOptions options = test::shape("boxes", faces);
  options.seed = seed;
  return make_shape(options);
}

Mesh rotated(Mesh mesh, double angle) {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(angle, Vec3::UnitZ()) *
                                    Eigen::AngleAxisd(0.7 * angle, Vec3(1, 2, 3).normalized()))
                                       .toRotationMatrix();
  for (Vec3& p : mesh.positions) p = rotation * p;
  return mesh;
}

Mesh in_singles(Mesh mesh) {
  for (Vec3& p : mesh.positions) {
    for (double& x : p) x = round_to_single(x);
  }
  return mesh;
}

// Checks that the result is closed and manifold, without intersections or faces of no area.
Mesh check_clean(const Mesh& mesh, Scalar coordinate) {
  CleanOptions options;
  options.coordinate = coordinate;
  Mesh result = clean(mesh, options).mesh;
  const test::Count count = test::count(result);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(find_intersections(result).empty());
  if (coordinate == Scalar::float32) CHECK(in_singles(result).positions == result.positions);
  for (const Face& f : result.faces) {
    const Vec3 &a = result.positions[f[0]], &b = result.positions[f[1]],
               &c = result.positions[f[2]];
    CHECK(!collinear(a, b, c));
  }
  return result;
}

}  // namespace

TEST_CASE("rotated lattice boxes: coplanar faces separated by rounding still give one solid") {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Mesh straight = boxes(seed, 500);
    const double volume = test::signed_volume(clean(straight).mesh);
    for (const double angle : {0.3, 1.1, 2.9}) {
      CAPTURE(seed);
      CAPTURE(angle);
      const Mesh result = check_clean(rotated(straight, angle), Scalar::float64);
      CHECK(test::signed_volume(result) == doctest::Approx(volume).epsilon(1e-6));
      const Mesh rough = check_clean(in_singles(rotated(straight, angle)), Scalar::float32);
      CHECK(test::signed_volume(rough) == doctest::Approx(volume).epsilon(1e-2));
    }
  }
}

TEST_CASE("stored shapes are clean at any distance from the origin") {
  for (const char* kind : {"two-spheres", "folded", "pinch", "dumbbell"}) {
    const Mesh shape = make_shape(test::shape(kind, 600));
    for (const double scale : {1e-3, 1e-9, 1e-12}) {
      CAPTURE(kind);
      CAPTURE(scale);
      const Vec3 away = scale == 1e-3 ? Vec3(1e6, 3e5, -1e6) : Vec3(1, 2, 3);
      check_clean(test::moved(test::scaled(shape, scale), away), Scalar::float64);
    }
    check_clean(in_singles(test::moved(shape, {1e5, 3e4, 0})), Scalar::float32);
  }
}

TEST_CASE("scaling changes nothing, up to where products overflow or vanish") {
  const Mesh straight = boxes(1, 500);
  const Mesh expected = clean(straight).mesh;
  for (const int exponent : {-100, -20, 20, 100}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    const Mesh result = clean(test::scaled(straight, scale)).mesh;
    CHECK(result.faces == expected.faces);
    CHECK(test::scaled(result, 1 / scale).positions == expected.positions);
  }
  // At scales beyond these, only the triangulation of faces may differ.
  for (const int exponent : {-300, 300}) {
    const Mesh result =
        check_clean(test::scaled(straight, std::ldexp(1.0, exponent)), Scalar::float64);
    const Mesh back = test::scaled(result, std::ldexp(1.0, -exponent));
    CHECK(test::signed_volume(back) == doctest::Approx(test::signed_volume(expected)));
    CHECK(test::count(back).genera == test::count(expected).genera);
  }
}

TEST_CASE("a shape that its coordinates cannot represent is refused with a reason") {
  const Mesh shape = in_singles(test::moved(test::scaled(test::icosphere(3), 1e-9), {1, 2, 3}));
  CHECK_THROWS_WITH_AS(clean(shape), doctest::Contains("no area"), GoalError);
}
