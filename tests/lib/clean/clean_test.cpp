// Options of clean(): columns of sources, moving copies apart, boxes.
#include "transformesh/clean.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/source_points.h"
#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

Mesh overlapping_boxes() {
  return test::joined(test::cuboid(Vec3::Zero(), Vec3::Ones()),
                      test::cuboid(Vec3::Constant(.5), Vec3::Constant(1.5)));
}

/// Two boxes that touch along an edge. Cleaning leaves two copies of the edge's vertices at the
/// same positions.
Mesh touching_boxes() {
  return test::joined(test::cuboid(Vec3::Zero(), Vec3::Ones()), test::cuboid({1, 1, 0}, {2, 2, 1}));
}

}  // namespace

TEST_CASE("the face column names the input face whose plane a face lies in") {
  const Mesh input = overlapping_boxes();
  CleanOptions options;
  options.sources = CleanSources::faces;
  const Mesh cleaned = clean(input, options).mesh;
  const Column* column = cleaned.face_columns.find("source_face");
  REQUIRE(column != nullptr);
  CHECK(cleaned.vertex_columns.find("source_face") == nullptr);
  for (Index f = 0; f < cleaned.faces.size(); ++f) {
    const auto source = static_cast<Index>(column->values[f]);
    const Vec3 normal = face_normal(input, source);
    CHECK(face_normal(cleaned, f).cross(normal).norm() < 1e-12);
    CHECK(face_normal(cleaned, f).dot(normal) > 0);
    const Vec3 from =
        cleaned.positions[cleaned.faces[f][0]] - input.positions[input.faces[source][0]];
    CHECK(std::abs(from.dot(normal)) < 1e-12);
  }
}

TEST_CASE("source points give back the positions of the output") {
  const Mesh input = overlapping_boxes();
  CleanOptions options;
  options.sources = CleanSources::points;
  const CleanResult result = clean(input, options);
  CHECK(!result.dropped_source_points);
  const SourcePoints places = read_source_points(result.mesh, input.faces.size(), "the input");
  for (Index v = 0; v < result.mesh.positions.size(); ++v)
    CHECK((position_of(input, places.of_vertices[v]) - result.mesh.positions[v]).norm() < 1e-12);
  CHECK(result.mesh.face_columns.find("tm:source-face") == nullptr);
}

TEST_CASE("source points are removed if only the face column is requested") {
  Mesh input = overlapping_boxes();
  write_source_points(input, closest_source_points(input, input));
  CleanOptions options;
  options.sources = CleanSources::faces;
  const CleanResult result = clean(input, options);
  CHECK(result.dropped_source_points);
  CHECK(!has_source_points(result.mesh));
}

TEST_CASE("copies are moved apart by the distance, or refused") {
  CleanOptions options;
  options.separate = .01;
  const CleanResult result = clean(touching_boxes(), options);
  CHECK(result.separated_vertices == 4);
  CHECK(result.changed);
  double least = 1;
  for (Index v = 0; v < result.mesh.positions.size(); ++v)
    for (Index w = 0; w < v; ++w)
      least = std::min(least, (result.mesh.positions[v] - result.mesh.positions[w]).norm());
  // Each copy moves by .005 into its box, along the diagonal of the box at that corner.
  CHECK(least == doctest::Approx(.01 * std::sqrt(2. / 3)));
  options.refuse = true;
  try {
    clean(clean(touching_boxes()).mesh, options);
    FAIL("copies were moved");
  } catch (const GoalError& error) {
    CHECK(error.kind() == ErrorKind::needs_cleaning);
  }
}

TEST_CASE("options that need the whole mesh exclude a box, and a box is needed for its faces") {
  CleanOptions options;
  options.only = true;
  CHECK_THROWS_AS(clean(test::cube(), options), UsageError);
  options.box = Box{Vec3::Zero(), Vec3::Ones()};
  CHECK_NOTHROW(clean(test::cube(), options));
  CleanOptions outermost = options, separate = options, fixed = options;
  outermost.outermost = true;
  separate.separate = .1;
  fixed.method = ExteriorMethod::static_test;
  CHECK_THROWS_AS(clean(test::cube(), outermost), UsageError);
  CHECK_THROWS_AS(clean(test::cube(), separate), UsageError);
  CHECK_THROWS_AS(clean(test::cube(), fixed), UsageError);
}

TEST_CASE("a mesh of doubles is rounded first if the result is stored as float") {
  const Mesh input = test::joined(test::moved(test::icosphere(4), Vec3(100, 0.01, 0.02)),
                                  test::moved(test::icosphere(4), Vec3(100.3, 0, 0)));
  CleanOptions options;
  options.coordinate = Scalar::float32;
  const CleanResult result = clean(input, options);
  CHECK(result.changed);
  CHECK(!rounded_mesh(result.mesh, Scalar::float32));
  CHECK(find_intersections(result.mesh).empty());
  const Mesh whole = test::moved(test::icosphere(4), Vec3(100, 0.01, 0.02));
  const CleanResult same = clean(whole, options);
  CHECK(!same.changed);
  CHECK(same.mesh.positions == rounded_mesh(whole, Scalar::float32)->positions);
}
