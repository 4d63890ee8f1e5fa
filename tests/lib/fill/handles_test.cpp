/// Surfaces after the removal of handles, compared with closed forms and the Euler characteristic.
#include "transformesh/handles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/shapes.h"

using namespace transformesh;

namespace {

Mesh shape(const std::string& kind, std::vector<std::string> parameters, std::size_t faces) {
  ShapeOptions options;
  options.kind = kind;
  options.parameters = std::move(parameters);
  options.faces = faces;
  return make_shape(options);
}

void check_closed(const Mesh& mesh) {
  const ManifoldReport found = check_manifold(mesh);
  CHECK((found.is_manifold() && found.is_oriented() && found.is_closed()));
}

}  // namespace

TEST_CASE("a ring that is cut becomes a bent rod") {
  const Mesh ring = test::torus(2, 0.5, 60, 24);
  Mesh rod = ring;
  const HandleResult result = remove_handles(rod, {.max_length = 3.2});
  CHECK(result.removed == 1);
  CHECK(result.refused == 0);
  check_closed(rod);
  CHECK(find_intersections(rod).empty());
  const Components parts = connected_components(rod);
  CHECK(parts.components.size() == 1);
  CHECK(parts.genus() == 0);
  // The ring has 60 edges along its axis. Each end of the cut is drawn back by a third of an edge.
  const double slice = 2.0 / 3 / 60;
  CHECK(volume(rod) == doctest::Approx(volume(ring) * (1 - slice)).epsilon(0.004));
  CHECK(result.new_vertices == rod.positions.size() - ring.positions.size());
  CHECK(result.new_faces == rod.faces.size() - ring.faces.size());
}

TEST_CASE("a narrow hole is closed, and a ring with a wide one around a thick tube stays") {
  const Mesh thick = test::torus(1, 0.9, 40, 80);
  Mesh closed = thick;
  CHECK(remove_handles(closed, {.max_length = 0.7}).removed == 1);
  check_closed(closed);
  CHECK(find_intersections(closed).empty());
  CHECK(connected_components(closed).genus() == 0);
  CHECK(volume(closed) > volume(thick));

  Mesh same = thick;
  CHECK(remove_handles(same, {.max_length = 0.6}).removed == 0);
  CHECK(same.positions == thick.positions);
  CHECK(same.faces == thick.faces);
}

TEST_CASE("all handles within the length are removed, and components stay") {
  for (const Mesh& mesh : {shape("genus", {"7"}, 4000), shape("tori", {}, 4000),
                           clean(shape("boxes", {}, 3000)).mesh}) {
    const Components before = connected_components(mesh);
    Mesh untied = mesh;
    const HandleResult result = remove_handles(untied, {.max_length = 1e3});
    check_closed(untied);
    const Components after = connected_components(untied);
    CHECK(after.components.size() == before.components.size());
    CHECK(before.genus() - after.genus() == static_cast<long>(result.removed));
    CHECK((after.genus() == 0 || result.refused > 0));
    CHECK(before.genus() >= 2);
    CHECK(result.removed > 0.9 * static_cast<double>(before.genus()));
  }
}

TEST_CASE("cleaned afterwards, handles do not come back") {
  Mesh mesh = shape("genus", {"5"}, 5000);
  remove_handles(mesh, {.max_length = 1e3});
  CHECK(connected_components(clean(mesh).mesh).genus() == 0);
}

/// A ring around the z axis with a ring-shaped cavity inside, rotated by `angle`.
Mesh ring_with_cavity(double tube, double angle) {
  Mesh cavity = test::reversed(test::torus(2, tube, 60, 16));
  const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
  for (Vec3& position : cavity.positions) position = turn * position;
  return test::joined(test::torus(2, 0.5, 64, 24), cavity);
}

TEST_CASE("a cavity stays sealed, and the components that cleaning finds are those of before") {
  for (const double tube : {0.1, 0.2, 0.3, 0.4})
    for (const double angle : {0.0, 0.4, 1.1}) {
      const Mesh hollow = ring_with_cavity(tube, angle);
      REQUIRE(connected_components(clean(hollow).mesh).components.size() == 2);
      Mesh untied = hollow;
      const HandleResult result = remove_handles(untied, {.max_length = 100});
      check_closed(untied);
      const Mesh cleaned = clean(untied).mesh;
      const Components parts = connected_components(cleaned);
      CHECK(parts.components.size() == 2);
      CHECK(parts.genus() == 2 - static_cast<long>(result.removed));
      CHECK(volume(cleaned) == doctest::Approx(volume(hollow)).epsilon(0.03));
      CHECK((result.removed == 2 || result.blocked > 0));
    }
}

TEST_CASE("a tunnel with something in it stays, and components in it are not lost") {
  // The hole of the ring is .1 wide.
  const Mesh thick = test::torus(1, 0.9, 40, 80);
  const Mesh bar = test::cuboid(Vec3(-0.02, -0.02, -3), Vec3(0.02, 0.02, 3));
  const Mesh barred = test::joined(thick, bar);
  Mesh untied = barred;
  const HandleResult result = remove_handles(untied, {.max_length = 0.7});
  CHECK(result.removed == 0);
  CHECK(result.blocked > 0);
  CHECK(untied.positions == barred.positions);

  // A bead in the middle of each of the narrowest loops.
  Mesh beaded = thick;
  for (const int loop : {-2, -1, 0, 1, 2}) {
    const double z = 0.9 * std::sin(loop * 2 * std::numbers::pi / 80);
    beaded = test::joined(beaded, test::moved(test::scaled(test::icosphere(1), 0.004), {0, 0, z}));
  }
  remove_handles(beaded, {.max_length = 0.8});
  CHECK(connected_components(clean(beaded).mesh).components.size() == 6);
}

TEST_CASE("columns are kept, and thin limbs that are no handles stay") {
  Mesh mesh = test::torus(2, 0.5, 30, 12);
  mesh.vertex_columns.get("heat", Scalar::float32, mesh.positions.size())
      .values.assign(mesh.positions.size(), 7);
  mesh.face_columns.get("label", Scalar::int32, mesh.faces.size())
      .values.assign(mesh.faces.size(), 3);
  const std::size_t faces = mesh.faces.size();
  const HandleResult result = remove_handles(mesh, {.max_length = 4});
  const std::vector<double>& heat = mesh.vertex_columns.find("heat")->values;
  CHECK(heat.size() == mesh.positions.size());
  CHECK(std::all_of(heat.begin(), heat.end(), [](double x) { return x == doctest::Approx(7); }));
  const std::vector<double>& label = mesh.face_columns.find("label")->values;
  CHECK(label.size() == faces + result.new_faces);
  CHECK(std::count(label.begin(), label.end(), 0) == static_cast<long>(result.new_faces));

  Mesh limb = shape("dumbbell", {}, 2000);
  const Mesh before = limb;
  CHECK(remove_handles(limb, {.max_length = 1e3}).removed == 0);
  CHECK(limb.positions == before.positions);
}

// The loops of this test have many equally good patches.
TEST_CASE("positions are those that floats hold, and always the same, for any number of threads") {
  Mesh first;
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    Mesh mesh = test::torus(2, 0.5, 60, 24);
    for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
    remove_handles(mesh, {.max_length = 4, .coordinate = Scalar::float32});
    for (const Vec3& p : mesh.positions) CHECK(p == p.cast<float>().cast<double>());
    if (threads == 1) first = mesh;
    CHECK(mesh.positions == first.positions);
    CHECK(mesh.faces == first.faces);
  }
}

TEST_CASE("open or non-manifold meshes, and invalid lengths, are refused") {
  Mesh open = test::torus(2, 0.5, 30, 12);
  open.faces.pop_back();
  CHECK_THROWS_AS(remove_handles(open, {.max_length = 1}), InputError);
  Mesh mesh = test::cube();
  CHECK_THROWS_AS(remove_handles(mesh, {.max_length = 0}), UsageError);
  CHECK_THROWS_AS(remove_handles(mesh, {.max_length = -1}), UsageError);
  Mesh empty;
  CHECK(remove_handles(empty, {.max_length = 1}).removed == 0);
}
