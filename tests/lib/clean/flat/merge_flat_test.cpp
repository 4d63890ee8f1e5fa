/// Flat regions get as few triangles as their outlines need, and nothing else changes.
#include "clean/flat/merge_flat.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "lib/clean/flat/flat_shapes.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/clean.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

MergeFlatResult merge_all(Mesh& mesh, double spacings = 64) {
  const std::vector<char> wanted(mesh.faces.size(), 1);
  return merge_flat(mesh, wanted, spacings, Scalar::float64, Progress());
}

void check_surface(const Mesh& mesh, const std::vector<long>& genera) {
  const test::Count count = test::count(mesh);
  CHECK(count.is_closed_and_oriented);
  CHECK(count.is_manifold);
  CHECK(!count.has_isolated_vertices);
  CHECK(count.genera == genera);
  CHECK(find_intersections(mesh).empty());
}

/// Moves each coordinate by up to `spacings` times the spacing of numbers at 1.
Mesh shaken(Mesh mesh, double spacings, std::uint64_t seed) {
  test::Random random(seed);
  const double spacing = spacing_around(Vec3::Ones(), Scalar::float64);
  for (Vec3& point : mesh.positions)
    for (double& x : point) x += spacings * spacing * random.uniform(-1, 1);
  return mesh;
}

/// Returns a mesh of unit cubes whose corners are multiples of `step`.
Mesh random_cubes(int count, int places, double step, std::uint64_t seed) {
  test::Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    Vec3 low;
    for (double& x : low) x = static_cast<double>(random.below(places)) * step;
    mesh = test::joined(mesh, test::cuboid(low, low + Vec3::Ones()));
  }
  return mesh;
}

}  // namespace

TEST_CASE("the sides of a cube get two triangles each, without movement") {
  for (const int n : {2, 3, 8}) {
    CAPTURE(n);
    Mesh mesh = test::grid_cube(n);
    const std::size_t before = mesh.faces.size();
    const MergeFlatResult result = merge_all(mesh);
    CHECK(mesh.faces.size() == 12);
    CHECK(mesh.positions.size() == 8);
    CHECK(result.removed_faces == before - 12);
    CHECK(result.regions == 6);
    CHECK(result.kept_regions == 0);
    CHECK(result.displacement == 0);
    CHECK(test::signed_volume(mesh) == doctest::Approx(1));
    check_surface(mesh, {0});
  }
}

TEST_CASE("a side with a hole keeps it") {
  Mesh mesh = test::grid_frame(4);
  merge_all(mesh);
  // Two sides with 4 + 4 corners and a hole have 8 triangles each; the other 8 sides have 2 each.
  CHECK(mesh.faces.size() == 32);
  CHECK(mesh.positions.size() == 16);
  CHECK(test::signed_volume(mesh) == doctest::Approx(8));
  check_surface(mesh, {1});
}

TEST_CASE("sides bent by rounding are merged, and the movement is bounded") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    CAPTURE(seed);
    const Mesh before = shaken(test::moved(test::grid_cube(6), Vec3::Ones()), 8, seed);
    Mesh mesh = before;
    const MergeFlatResult result = merge_all(mesh);
    CHECK(mesh.faces.size() == 12);
    CHECK(result.displacement > 0);
    CHECK(result.displacement < 200 * spacing_around(Vec3::Ones(), Scalar::float64));
    check_surface(mesh, {0});
    // Every input vertex is at most `displacement` from the plane of a face of the result.
    for (const Vec3& point : before.positions) {
      double nearest = 1;
      for (Index f = 0; f < mesh.faces.size(); ++f) {
        const Vec3 a = mesh.positions[mesh.faces[f][0]];
        const Vec3 normal = (mesh.positions[mesh.faces[f][1]] - a)
                                .cross(mesh.positions[mesh.faces[f][2]] - a)
                                .normalized();
        nearest = std::min(nearest, std::abs(normal.dot(point - a)));
      }
      CHECK(nearest <= result.displacement);
    }
  }
}

TEST_CASE("vertices farther from a plane than the tolerance stay") {
  Mesh mesh = test::grid_cube(4);
  for (Vec3& point : mesh.positions)
    if (point == Vec3(.5, .5, 1)) point.z() += 1e-9;
  merge_all(mesh);
  // The top keeps its raised middle vertex and the vertices around it, because faces there are not
  // flat.
  CHECK(mesh.faces.size() > 12);
  CHECK(std::count(mesh.positions.begin(), mesh.positions.end(), Vec3(.5, .5, 1 + 1e-9)) == 1);
  check_surface(mesh, {0});
}

TEST_CASE("borders between properties of faces stay") {
  Mesh mesh = test::grid_cube(4);
  std::vector<double>& material =
      mesh.face_columns.get("material", Scalar::int32, mesh.faces.size()).values;
  const auto is_left = [&](Index f) {
    return std::all_of(mesh.faces[f].begin(), mesh.faces[f].end(),
                       [&](Index v) { return mesh.positions[v].x() <= .5; });
  };
  for (Index f = 0; f < mesh.faces.size(); ++f) material[f] = is_left(f) ? 1 : 2;
  merge_all(mesh);
  // Four sides have faces of both materials and are divided; the other two are not.
  CHECK(mesh.faces.size() == 20);
  CHECK(mesh.positions.size() == 12);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    CHECK(mesh.face_columns.columns[0].values[f] == (is_left(f) ? 1 : 2));
  check_surface(mesh, {0});
}

TEST_CASE("regions without a selected face keep their faces") {
  Mesh mesh = test::grid_cube(4);
  std::vector<char> wanted(mesh.faces.size(), 0);
  const std::size_t before = mesh.faces.size();
  CHECK(merge_flat(mesh, wanted, 64, Scalar::float64, Progress()).removed_faces == 0);
  CHECK(mesh.faces.size() == before);
  for (Index f = 0; f < mesh.faces.size(); ++f)
    wanted[f] = mesh.positions[mesh.faces[f][0]].z() == 1 && face_normal(mesh, f).z() > 0;
  merge_flat(mesh, wanted, 64, Scalar::float64, Progress());
  // The top keeps the 16 vertices of its outline.
  CHECK(mesh.faces.size() == before - 32 + 14);
  check_surface(mesh, {0});
}

TEST_CASE("where sheets touch, vertices stay") {
  const Mesh cube = test::grid_cube(4);
  Mesh mesh = test::joined(cube, test::moved(cube, {1, 1, 0}));
  merge_all(mesh);
  // Each body keeps its 8 corners, and three vertices on the edge along which the bodies touch.
  CHECK(mesh.positions.size() == 22);
  check_surface(mesh, {0, 0});
}

TEST_CASE("bodies of cells keep volume and topology, whatever touches") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U}) {
    CAPTURE(seed);
    const Mesh cubes = random_cubes(40, 4, 1, seed);
    CleanOptions options;
    const Mesh plain = clean(cubes, options).mesh;
    options.merge_flat = true;
    const CleanResult merged = clean(cubes, options);
    CHECK(merged.merge_displacement == 0);
    CHECK(merged.mesh.faces.size() <= plain.faces.size());
    CHECK(test::signed_volume(merged.mesh) == doctest::Approx(test::signed_volume(plain)));
    check_surface(merged.mesh, test::count(plain).genera);
  }
}

TEST_CASE("bodies whose sides are a spacing apart stay closed from step to step") {
  for (const std::uint64_t seed : {1U, 2U}) {
    CAPTURE(seed);
    CleanOptions options;
    options.merge_flat = true;
    Mesh mesh = test::cube();
    double expected = 0;
    for (std::uint64_t step = 0; step < 40; ++step) {
      CAPTURE(step);
      const Mesh both = test::joined(mesh, random_cubes(1, 12, 1 / 3., 100 * seed + step));
      expected = test::signed_volume(clean(both).mesh);
      mesh = clean(both, options).mesh;
      REQUIRE(test::count(mesh).is_closed_and_oriented);
      CHECK(test::count(mesh).is_manifold);
      CHECK(test::signed_volume(mesh) == doctest::Approx(expected).epsilon(1e-12));
      CHECK(find_intersections(mesh).empty());
    }
  }
}
