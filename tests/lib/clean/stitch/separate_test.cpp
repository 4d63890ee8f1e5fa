#include "clean/stitch/separate.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <set>

#include "helpers/cgal_oracle.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/clean.h"

using namespace transformesh;

namespace {

std::size_t count_places(const Mesh& mesh) {
  std::set<std::array<double, 3>> places;
  for (const Vec3& p : mesh.positions) places.insert({p.x(), p.y(), p.z()});
  return places.size();
}

double area_around(const Mesh& mesh, Index vertex) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    if (a != vertex && b != vertex && c != vertex) continue;
    const Vec3& p = mesh.positions[a];
    area += (mesh.positions[b] - p).cross(mesh.positions[c] - p).norm() / 2;
  }
  return area;
}

/// Returns a bound on the change of volume when vertices move one after another: a third of each
/// step times the surrounding area. Steps of the corners enlarge these areas, which the factor
/// covers.
double volume_bound(const Mesh& before, const Mesh& after) {
  double bound = 0;
  for (Index v = 0; v < before.positions.size(); ++v) {
    const double step = (after.positions[v] - before.positions[v]).norm();
    if (step == 0) continue;
    bound += step / 3 * std::max(area_around(before, v), area_around(after, v));
  }
  return 2 * bound;
}

std::size_t count_flipped(const Mesh& before, const Mesh& after) {
  const auto normal = [](const Mesh& mesh, const Face& f) {
    const Vec3& p = mesh.positions[f[0]];
    return (mesh.positions[f[1]] - p).cross(mesh.positions[f[2]] - p).stableNormalized();
  };
  return static_cast<std::size_t>(std::count_if(
      before.faces.begin(), before.faces.end(),
      [&](const Face& face) { return normal(before, face).dot(normal(after, face)) <= 0; }));
}

Mesh check_apart(const Mesh& before, double distance, Scalar coordinate = Scalar::float64) {
  const std::size_t places = count_places(before);
  CHECK(places < before.positions.size());
  Mesh after = before;
  const SeparateResult result = separate(after, {distance, coordinate});
  CHECK(result.refused_vertices == 0);
  CHECK(count_places(after) == after.positions.size());
  CHECK(after.faces == before.faces);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < after.positions.size(); ++v) {
    const double step = (after.positions[v] - before.positions[v]).norm();
    CHECK(step < distance * 0.5001 + (coordinate == Scalar::float32 ? 1e-6 : 0));
    moved += step > 0 ? 1U : 0U;
  }
  CHECK(moved == result.separated_vertices);
  CHECK(count_flipped(before, after) == 0);
  CHECK(moved >= after.positions.size() - places);
  const test::Count facts = test::count(after);
  CHECK(facts.is_closed_and_oriented);
  CHECK(facts.is_manifold);
  CHECK(test::count_self_intersections(after) == 0);
  CHECK(std::abs(test::signed_volume(after) - test::signed_volume(before)) <=
        volume_bound(before, after));
  return after;
}

Mesh rotated(Mesh mesh, std::uint64_t seed) {
  test::Random random(seed);
  const Eigen::AngleAxisd rotation(random.uniform(0, 3), random.point(-1, 1).normalized());
  for (Vec3& p : mesh.positions) p = rotation * p;
  return mesh;
}

/// A tetrahedron with its tip at (0.5, 0.5, 1) and its base below.
Mesh hanging(double depth, double width) {
  Mesh mesh = test::tetrahedron();
  mesh.positions = {{.5, .5, 1},
                    {.5 + .8 * width, .5, 1 - depth},
                    {.5 - .4 * width, .5 + .6 * width, 1 - depth},
                    {.5 - .4 * width, .5 - .6 * width, 1 - depth}};
  return test::signed_volume(mesh) > 0 ? mesh : test::reversed(mesh);
}

double highest(const Mesh& mesh) {
  double z = -1e300;
  for (const Vec3& p : mesh.positions) z = std::max(z, p.z());
  return z;
}

}  // namespace

TEST_CASE("cubes that share a corner are moved apart by the distance") {
  const Mesh cubes = clean(test::joined(test::cube(), test::moved(test::cube(), {1, 1, 1}))).mesh;
  const Mesh apart = check_apart(cubes, 0.1);
  double least = 1e300;
  for (std::size_t a = 0; a < 8; ++a) {
    for (std::size_t b = 8; b < 16; ++b) {
      least = std::min(least, (apart.positions[a] - apart.positions[b]).norm());
    }
  }
  CHECK(least == doctest::Approx(0.1));
  // Each cube loses at most a corner pyramid: three faces of two triangles.
  CHECK(test::signed_volume(apart) < 2);
  CHECK(test::signed_volume(apart) > 2 - 0.1);
}

TEST_CASE("cubes that share edges or parts of edges are moved apart, for any rotation") {
  for (const Vec3& shift : {Vec3(1, 1, 0), Vec3(1, 0, 1), Vec3(1, 1, .5), Vec3(1, .25, 1)}) {
    CAPTURE(shift.transpose());
    const Mesh cubes = test::joined(test::cube(), test::moved(test::cube(), shift));
    check_apart(clean(cubes).mesh, 0.05);
    check_apart(clean(test::scaled(cubes, 1e-30)).mesh, 0.05e-30);
  }
  const Mesh four = test::joined(
      test::joined(test::cube(), test::moved(test::cube(), {1, 1, 0})),
      test::joined(test::moved(test::cube(), {1, 0, 1}), test::moved(test::cube(), {0, 1, 1})));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) check_apart(rotated(clean(four).mesh, seed), 0.1);
}

TEST_CASE("a cavity that touches its wall and the wall move away from each other") {
  Mesh touching = clean(test::joined(test::cube(), test::reversed(hanging(0.5, 0.3)))).mesh;
  const Mesh apart = check_apart(touching, 0.1);
  CHECK(highest(apart) == doctest::Approx(1.05));
  CHECK(test::winding_number(apart, {.5, .5, 1.02}) == doctest::Approx(1));
  CHECK(test::winding_number(apart, {.5, .5, .98}) == doctest::Approx(1));
  CHECK(test::winding_number(apart, {.5, .5, .8}) == doctest::Approx(0));

  // A body in the cavity touches the cavity and the cube at one point. The vertex of the cavity is
  // between the others and does not move.
  touching = clean(test::joined(test::joined(test::cube(), test::reversed(hanging(0.5, 0.3))),
                                hanging(0.4, 0.1)))
                 .mesh;
  const Mesh nested = check_apart(touching, 0.02);
  CHECK(highest(nested) == doctest::Approx(1.01));
  CHECK(std::count(nested.positions.begin(), nested.positions.end(), Vec3(.5, .5, 1)) == 1);
  CHECK(test::winding_number(nested, {.5, .5, 1.005}) == doctest::Approx(1));
  CHECK(test::winding_number(nested, {.5, .5, .995}) == doctest::Approx(0));
  CHECK(test::winding_number(nested, {.5, .5, .98}) == doctest::Approx(1));
}

TEST_CASE("a step does not pass through other faces") {
  const Mesh bubble = test::moved(test::scaled(test::icosphere(1), 0.01), {.9, .9, .9});
  const Mesh bodies = test::joined(test::joined(test::cube(), test::reversed(bubble)),
                                   test::moved(test::cube(), {1, 1, 1}));
  const Mesh apart = check_apart(clean(bodies).mesh, 0.8);
  CHECK(test::winding_number(apart, {.9, .9, .9}) == doctest::Approx(0));
  CHECK(test::winding_number(apart, {.9, .9, .92}) == doctest::Approx(1));
}

TEST_CASE("coincident vertices of cleaned workloads are moved apart, by small and large steps") {
  for (const char* kind : {"boxes", "pinch", "folded"}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      ShapeOptions options = test::shape(kind, 3000);
      options.seed = seed;
      const Mesh mesh = clean(make_shape(options)).mesh;
      if (count_places(mesh) == mesh.positions.size()) continue;
      CAPTURE(kind);
      CAPTURE(seed);
      const double edge = test::mean_edge(mesh);
      for (const double distance : {1e-3 * edge, 0.1 * edge, 3 * edge}) check_apart(mesh, distance);
    }
  }
}

TEST_CASE("vertices are moved apart in floats, or not at all") {
  const Mesh cubes = test::joined(test::cube(), test::moved(test::cube(), {1, 1, 0}));
  const Mesh apart = check_apart(clean(cubes).mesh, 0.1, Scalar::float32);
  for (const Vec3& p : apart.positions) {
    for (const double x : p) CHECK(x == round_to_single(x));
  }
  Mesh same = clean(cubes).mesh;
  const std::vector<Vec3> before = same.positions;
  const SeparateResult result = separate(same, {1e-9, Scalar::float32});
  CHECK(result.separated_vertices == 0);
  CHECK(result.refused_vertices == 4);
  CHECK(same.positions == before);
}

TEST_CASE("surfaces that do not touch stay unchanged") {
  Mesh mesh = test::joined(test::icosphere(2), test::moved(test::icosphere(2), {3, 0, 0}));
  const std::vector<Vec3> before = mesh.positions;
  CHECK(separate(mesh, {0.1}).separated_vertices == 0);
  CHECK(mesh.positions == before);
}
