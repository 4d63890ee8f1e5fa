#include "transformesh/morph_step.h"

#include <doctest/doctest.h>

#include <limits>

#include "helpers/shapes.h"
#include "step/morph_step_query.h"
#include "step/morph_velocities.h"
#include "step/prepare_target.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("steps bring a sphere onto a concentric one, each by a clamp, the last by the rest") {
  const Target target = make_target(test::icosphere(3));
  Mesh mesh = test::scaled(test::icosphere(3), 1.2);
  for (int i = 0; i < 20; ++i) {
    const double before = mesh.positions[0].norm();
    const double clamp = 0.2 * edge_lengths(mesh).maximum;
    const MorphStepResult result = morph_step(mesh, target);
    CHECK(result.displaced.max_displacement <= clamp * (1 + 1e-12));
    CHECK(mesh.positions[0].norm() < before + 1e-12);
  }
  const MorphStepResult last = morph_step(mesh, target);
  CHECK(last.to_target.maximum < 1e-3);
  CHECK(last.from_target.maximum < 2e-3);
  CHECK(last.displaced.max_clamp_share < 0.05);
}

TEST_CASE("movements are those of exact distances, however far away") {
  const Target target = make_target(test::torus(1, 0.4, 60, 30));
  for (const double radius : {0.7, 1.6, 5.0}) {
    const Mesh before = test::scaled(test::icosphere(4), radius);
    Mesh expected = before;
    displace(expected, morph_velocities(before, target).velocities);
    Mesh mesh = before;
    morph_step(mesh, target);
    double largest = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      largest = std::max(largest, (mesh.positions[v] - expected.positions[v]).norm());
    CHECK(largest < 1e-14 * radius);
  }
}

TEST_CASE("targets of points use tangent planes, and a mask fixes vertices") {
  const Mesh sphere = test::icosphere(3);
  Mesh points;
  points.positions = sphere.positions;
  set_normal_columns(points, vertex_normals(sphere));
  Mesh mesh = test::scaled(sphere, 1.5);
  mesh.vertex_columns.get("free", Scalar::uint8, mesh.positions.size()).values[7] = 1;
  const Mesh before = mesh;
  MorphStepOptions options;
  options.mask = "free";
  const MorphStepResult result = morph_step(mesh, make_target(points), options);
  CHECK(result.distance == MorphDistance::points);
  CHECK(result.displaced.moved == 1);
  CHECK(mesh.positions[6] == before.positions[6]);
  CHECK(mesh.positions[7] != before.positions[7]);

  options.mask = "none such";
  CHECK_THROWS_AS(morph_step(mesh, make_target(points), options), InputError);
}
