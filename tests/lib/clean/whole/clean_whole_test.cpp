#include <doctest/doctest.h>

#include "geometry/numbers/predicates.h"
#include "helpers/mesh_facts.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "helpers/winding_oracle.h"
#include "mesh/adjacency.h"
#include "mesh/coordinate_spacing.h"
#include "support/parallel.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

void check_promises(const Mesh& input, const Mesh& output) {
  const ManifoldReport report = check_manifold(output);
  CHECK(report.is_manifold());
  CHECK(report.is_oriented());
  CHECK(report.is_closed());
  CHECK(degenerate_faces(output).empty());
  CHECK(report.isolated_vertices.empty());
  CHECK(find_intersections(output).empty());
  const auto oracle = test::compare_windings(input, output);
  INFO(test::describe(oracle));
  CHECK(oracle.is_right());
}

}  // namespace

TEST_CASE("the seven workloads are cleaned correctly, and both methods give the same bytes") {
  for (const char* kind :
       {"two-spheres", "folded", "tangle", "dumbbell", "many-spheres", "boxes", "pinch"}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      CAPTURE(kind);
      CAPTURE(seed);
      const Mesh input = test::workload(kind, 6000, seed);
      const CleanResult grown = clean(input);
      CHECK(grown.pairs > 0);
      check_promises(input, grown.mesh);
      CleanOptions options;
      options.method = ExteriorMethod::static_test;
      const CleanResult tested = clean(input, options);
      CHECK(grown.mesh.positions == tested.mesh.positions);
      CHECK(grown.mesh.faces == tested.mesh.faces);
    }
  }
}

TEST_CASE("a clean mesh is returned unchanged") {
  const Mesh input =
      test::joined(test::icosphere(3), test::moved(test::torus(1, .3, 40, 16), {4, 0, 0}));
  const CleanResult result = clean(input);
  CHECK(!result.changed);
  CHECK(result.mesh.positions == input.positions);
  CHECK(result.mesh.faces == input.faces);
  CHECK(result.rays == 2);
  REQUIRE(result.connectivity);
  CHECK(result.connectivity->opposites == opposite_halfedges(input));
  CHECK(result.connectivity->components == 2);
  CHECK(connected_components(input, *result.connectivity).genus() == 1);
  CleanOptions options;
  options.refuse = true;
  CHECK(!clean(input, options).changed);
}

TEST_CASE("connectivity is returned only if nothing changes") {
  const Mesh ball = test::icosphere(3);
  const Mesh inside = test::scaled(ball, 0.5);
  CHECK(!clean(test::joined(ball, inside)).connectivity);
  CHECK(!clean(test::soup_of(ball)).connectivity);

  // A cavity stays unless `outermost` drops it.
  const Mesh hollow = test::joined(ball, test::reversed(inside));
  const CleanResult kept = clean(hollow);
  REQUIRE(kept.connectivity);
  CHECK(kept.connectivity->components == 2);
  CleanOptions options;
  options.outermost = true;
  const CleanResult dropped = clean(hollow, options);
  CHECK(dropped.changed);
  CHECK(!dropped.connectivity);
  CHECK(dropped.mesh.faces == ball.faces);
}

TEST_CASE("a clean result is clean") {
  for (const char* kind : {"two-spheres", "tangle", "boxes", "pinch"}) {
    CAPTURE(kind);
    const Mesh once = clean(test::workload(kind, 1500, 4)).mesh;
    const CleanResult twice = clean(once);
    CHECK(!twice.changed);
    CHECK(twice.mesh.faces == once.faces);
  }
}

TEST_CASE("winding level 2 is the intersection, and a flipped operand the difference") {
  const Mesh a = test::icosphere(3);
  const Mesh b = test::moved(test::icosphere(3), {0.7, 0.21, 0.13});
  CleanOptions twice;
  twice.winding_level = 2;
  const double sum = volume(clean(test::joined(a, b)).mesh);
  const CleanResult common = clean(test::joined(a, b), twice);
  const double difference = volume(clean(test::joined(a, test::reversed(b))).mesh);
  CHECK(sum + volume(common.mesh) == doctest::Approx(volume(a) + volume(b)).epsilon(1e-12));
  CHECK(difference + volume(common.mesh) == doctest::Approx(volume(a)).epsilon(1e-12));
  test::WindingOracleOptions options;
  options.winding_level = 2;
  CHECK(test::compare_windings(test::joined(a, b), common.mesh, options).is_right());
  twice.winding_level = 3;
  CHECK_THROWS_AS(clean(test::joined(a, b), twice), GoalError);
}

TEST_CASE("untouched faces keep their place and columns; new ones inherit and interpolate") {
  Mesh input = test::workload("two-spheres", 2000);
  Column& x = input.vertex_columns.get("x_copy", Scalar::float64, input.positions.size());
  for (std::size_t v = 0; v < input.positions.size(); ++v) x.values[v] = input.positions[v][0];
  Column& id = input.face_columns.get("id", Scalar::int32, input.faces.size());
  for (std::size_t f = 0; f < input.faces.size(); ++f) id.values[f] = static_cast<double>(f);
  const CleanResult result = clean(input);
  const Mesh& mesh = result.mesh;
  const Column& mesh_x = *mesh.vertex_columns.find("x_copy");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    REQUIRE(std::abs(mesh_x.values[v] - mesh.positions[v][0]) < 1e-9);
  }

  // Every face lies in the plane of the face whose id it inherited; uncut faces equal it.
  const Column& mesh_id = *mesh.face_columns.find("id");
  std::size_t whole = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Face& source = input.faces[static_cast<std::size_t>(mesh_id.values[f])];
    const Vec3 &a = input.positions[source[0]], &b = input.positions[source[1]],
               &c = input.positions[source[2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    for (const Index v : mesh.faces[f]) {
      REQUIRE(std::abs(normal.dot(mesh.positions[v] - a)) < 1e-9);
    }
    REQUIRE(normal.dot(face_normal(mesh, f)) > 0);
    whole += mesh.positions[mesh.faces[f][0]] == a && mesh.positions[mesh.faces[f][1]] == b &&
                     mesh.positions[mesh.faces[f][2]] == c
                 ? 1U
                 : 0U;
  }
  CHECK(whole == input.faces.size() - result.cut_faces - result.removed_faces);
}

TEST_CASE("the same bytes for any number of threads") {
  const Mesh input = test::workload("many-spheres", 3000, 5);
  const Mesh first = [&] {
    const ThreadLimit limit(1);
    return clean(input).mesh;
  }();
  for (const int threads : {2, 4}) {
    const ThreadLimit limit(threads);
    const Mesh again = clean(input).mesh;
    CHECK(again.positions == first.positions);
    CHECK(again.faces == first.faces);
  }
}

TEST_CASE("float coordinates are free of self-intersections as floats") {
  Mesh input = test::workload("many-spheres", 3000, 6);
  for (Vec3& p : input.positions) {
    for (double& value : p) value = round_to_single(value);
  }
  CleanOptions options;
  options.coordinate = Scalar::float32;
  const Mesh mesh = clean(input, options).mesh;
  for (const Vec3& p : mesh.positions) {
    for (const double value : p) REQUIRE(value == round_to_single(value));
  }
  CHECK(find_intersections(mesh).empty());
  test::WindingOracleOptions tolerant;
  tolerant.tolerance = 1e-6;
  CHECK(test::compare_windings(input, mesh, tolerant).is_right());
}

TEST_CASE("meshes that cannot be cleaned are refused with a reason") {
  Mesh misoriented = test::icosphere(1);
  std::swap(misoriented.faces[5][0], misoriented.faces[5][1]);
  CHECK_THROWS_WITH_AS(clean(misoriented), doctest::Contains("the mesh is not oriented"),
                       InputError);
  CHECK_THROWS_WITH_AS(clean(test::reversed(test::icosphere(1))),
                       doctest::Contains("no point has a winding number >= 1"), GoalError);
  CHECK_THROWS_AS(clean(Mesh()), InputError);
  CleanOptions options;
  options.method = ExteriorMethod::static_test;
  CHECK_THROWS_AS(clean(test::grid(3), options), UsageError);
  options = {};
  options.refuse = true;
  CHECK_THROWS_AS(clean(test::workload("two-spheres", 500), options), GoalError);
}

TEST_CASE("soups and singular vertices are stitched") {
  const Mesh joined = clean(test::soup_of(test::cube())).mesh;
  CHECK(joined.positions.size() == 8);
  CHECK(test::count(joined).is_closed_and_oriented);

  // Two tetrahedra that share one vertex by index.
  Mesh hourglass = test::tetrahedron();
  const Mesh other = test::reversed(test::scaled(test::tetrahedron(), -1));
  for (std::size_t v = 1; v < 4; ++v) hourglass.positions.push_back(other.positions[v]);
  for (Face f : other.faces) {
    for (Index& v : f) v = v == 0 ? 0 : v + 3;
    hourglass.faces.push_back(f);
  }
  const CleanResult parted = clean(hourglass);
  CHECK(parted.mesh.positions.size() == 8);
  CHECK(parted.copied_vertices == 1);
  CHECK(test::count(parted.mesh).is_manifold);
}

TEST_CASE("faces too large to be cut are refused with their place, and those within are cut") {
  const Mesh boxes = test::joined(test::cuboid({-1, -1, -1}, {0.5, 0.5, 0.5}),
                                  test::cuboid({-0.25, -0.25, -0.25}, {1, 1, 1}));
  CHECK_THROWS_WITH_AS(clean(test::scaled(boxes, 1.7e308)),
                       doctest::Contains("too large to cut faces there: scale the mesh"),
                       InputError);
  CHECK(clean(test::scaled(boxes, 0x1p1016)).mesh.faces.size() == clean(boxes).mesh.faces.size());
}
