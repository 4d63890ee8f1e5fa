// Necks and handles that separate. CGAL counts self-intersections.
#include "remesh/pinch.h"

#include <doctest/doctest.h>

#include <numbers>

#include "helpers/cgal_oracle.h"
#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"
#include "transformesh/shapes.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

Mesh dumbbell(double neck) {
  ShapeOptions options;
  options.kind = "dumbbell";
  options.faces = 6000;
  options.neck = neck;
  return make_shape(options);
}

RemeshOptions pinching(const Mesh& mesh, double length) {
  RemeshOptions options = curved_remeshing();
  const double edge = edge_lengths(mesh).mean;
  options.min_edge = 0.7 * edge;
  options.max_edge = 1.5 * edge;
  options.pinch = length;
  return options;
}

}  // namespace

TEST_CASE("a dumbbell parts if a loop around its neck is short enough, and keeps its volume") {
  const Mesh whole = dumbbell(0.1);
  const double loop = 2 * std::numbers::pi * 0.1;
  for (const bool is_short : {false, true}) {
    CAPTURE(is_short);
    Mesh mesh = whole;
    const RemeshResult result = remesh(mesh, pinching(whole, (is_short ? 1.1 : 0.9) * loop));
    CHECK(result.pinched == (is_short ? 1 : 0));
    CHECK(result.pinch_refused == 0);
    CHECK(connected_components(mesh).components.size() == (is_short ? 2 : 1));
    CHECK(euler_number(mesh) == (is_short ? 4 : 2));
    CHECK(volume(mesh) == doctest::Approx(volume(whole)).epsilon(2e-3));
    CHECK(is_closed(mesh));
    CHECK(is_oriented_manifold(mesh));
    CHECK(count_self_intersections(mesh) == 0);
  }
}

TEST_CASE("handles part as necks do") {
  const Mesh ring = torus(2, 0.5, 60, 24);
  Mesh mesh = ring;
  CHECK(remesh(mesh, pinching(ring, 3)).pinched == 0);
  CHECK(euler_number(mesh) == 0);
  CHECK(remesh(mesh, pinching(ring, 3.3)).pinched == 1);
  CHECK(euler_number(mesh) == 2);
  CHECK(count_self_intersections(mesh) == 0);
}

TEST_CASE("a mesh without necks stays as it is") {
  const Mesh sphere = icosphere(3);
  Mesh mesh = sphere;
  CHECK(pinch(mesh, 1, Scalar::float64, {}).cut == 0);
  CHECK(is_same(mesh, sphere));
}

TEST_CASE("open meshes and impossible lengths are refused, and the mesh stays") {
  const Mesh sheet = grid(4);
  Mesh mesh = sheet;
  CHECK_THROWS_AS(remesh(mesh, pinching(sheet, 0.1)), InputError);
  CHECK_THROWS_AS(remesh(mesh, pinching(sheet, -1)), UsageError);
  CHECK_THROWS_AS(remesh(mesh, pinching(sheet, NAN)), UsageError);
  RemeshOptions smoothing = pinching(sheet, 0.1);
  smoothing.only_smooth = true;
  smoothing.smoothing = Smoothing::tangential;
  CHECK_THROWS_AS(remesh(mesh, smoothing), UsageError);
  CHECK(is_same(mesh, sheet));
}
