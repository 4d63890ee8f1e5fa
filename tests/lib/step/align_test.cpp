#include "transformesh/align.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "support/random.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/shapes.h"

using namespace transformesh;

namespace {

Vec3 random_direction(Random& random) {
  Vec3 v = Vec3::Zero();
  while (v.norm() < 0.1 || v.norm() > 1)
    v = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return v.normalized();
}

/// Returns the sum of twelve uniform numbers, which is nearly normal with standard deviation 1.
double bell(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.uniform(0, 1);
  return sum;
}

/// Returns the faces whose first corner is among the lowest `share` of the vertices along a
/// direction.
Mesh lowest_part(const Mesh& mesh, const Vec3& direction, double share) {
  std::vector<double> heights;
  for (const Vec3& p : mesh.positions) heights.push_back(direction.dot(p));
  std::ranges::sort(heights);
  const double limit =
      heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))];
  std::vector<bool> keep;
  for (const Face& face : mesh.faces)
    keep.push_back(direction.dot(mesh.positions[face[0]]) < limit);
  return select_faces(mesh, keep);
}

void add_noise(Mesh& mesh, double amplitude, Random& random) {
  for (Vec3& p : mesh.positions) p += amplitude * Vec3(bell(random), bell(random), bell(random));
}

/// Adds single triangles around the surface, a tenth as many as it has faces.
void add_outliers(Mesh& mesh, double reach, Random& random) {
  const std::size_t count = mesh.faces.size();
  for (std::size_t f = 0; f < count; f += 10) {
    const Vec3 away = reach * random.uniform(0, 1) * random_direction(random);
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const Index corner : mesh.faces[f])
      mesh.positions.push_back(mesh.positions[corner] + away);
    mesh.faces.push_back({first, first + 1, first + 2});
  }
}

struct Scans {
  Mesh reference, mesh, truth;  ///< `truth` is the mesh without noise and outliers
  Matrix4 misplacement;
};

/// Two scans that each lack a quarter of the shape, at opposite ends, 20 degrees and a tenth of the
/// diagonal apart.
Scans scans_of(const Mesh& whole, double noise, std::uint64_t seed) {
  Random random(seed);
  const double size = diagonal_of(bounding_box(whole));
  const Vec3 end = random_direction(random);
  Scans scans{lowest_part(whole, end, 0.75), lowest_part(whole, -end, 0.75), {}, {}};
  scans.truth = scans.mesh;
  add_noise(scans.reference, noise * size, random);
  add_noise(scans.mesh, noise * size, random);
  add_outliers(scans.mesh, 0.3 * size, random);
  scans.misplacement = translation_by(0.1 * size * random_direction(random)) *
                       rotation_about(random_direction(random), 20);
  transform(scans.mesh, scans.misplacement);
  return scans;
}

/// Returns the largest distance of a vertex from its true position, in diagonals.
double error_of(const Scans& scans, const RegistrationResult& result) {
  const Matrix4 rest = result.motion * scans.misplacement;
  double largest = 0;
  for (const Vec3& p : scans.truth.positions) {
    const Vec3 moved = rest.topLeftCorner<3, 3>() * p + Vec3(rest.topRightCorner<3, 1>());
    largest = std::max(largest, (moved - p).norm());
  }
  return largest / diagonal_of(bounding_box(scans.truth));
}

}  // namespace

TEST_CASE("partial scans with noise and outliers are aligned from 20 degrees and 10 % away") {
  for (const char* kind : {"dented", "figure", "genus", "torus-knot"}) {
    const Mesh whole = make_shape(test::shape(kind, 10000));
    for (const std::uint64_t seed : {1, 2, 3}) {
      CAPTURE(kind);
      CAPTURE(seed);
      Scans scans = scans_of(whole, 0.002, seed);
      const RegistrationResult result = align(scans.mesh, scans.reference);
      CHECK(result.has_converged);
      CHECK(error_of(scans, result) < 0.01);
      CHECK(result.overlap > 0.3);
      CHECK(result.overlap < 0.75);
    }
  }
}

TEST_CASE("exact copies are aligned exactly, for any size and place") {
  const Mesh shape = make_shape(test::shape("dented", 3000));
  for (const double scale : {1e-150, 1.0, 1e100}) {
    Mesh reference = shape;
    for (Vec3& p : reference.positions) p = scale * (p + Vec3(3, 0, 0));
    Mesh mesh = reference;
    transform(mesh, translation_by(scale * Vec3(0.2, 0.1, 0)) * rotation_about({0, 0, 1}, 5));
    const RegistrationResult result = align(mesh, reference);
    CHECK(result.overlap > 0.99);
    CHECK(result.rms < 1e-6 * scale);
    double largest = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      largest = std::max(largest, (mesh.positions[v] - reference.positions[v]).norm());
    CHECK(largest < 1e-6 * scale);
  }
}

TEST_CASE("a soup has no borders inside, and columns follow") {
  const Mesh reference = make_shape(test::shape("dented", 2000));
  Mesh soup;
  for (const Face& face : reference.faces) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index corner : face) soup.positions.push_back(reference.positions[corner]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  Mesh mesh = reference;
  Column& nx = mesh.vertex_columns.get("nx", Scalar::float64, mesh.positions.size());
  nx.values.assign(mesh.positions.size(), 1);
  for (const char* name : {"ny", "nz"})
    mesh.vertex_columns.get(name, Scalar::float64, mesh.positions.size());
  transform(mesh, rotation_about({0, 0, 1}, 10));
  const RegistrationResult result = align(mesh, soup);
  CHECK(result.overlap > 0.99);
  CHECK(mesh.vertex_columns.find("nx")->values[7] == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("a sphere slides, and a box does not") {
  Mesh sphere = test::icosphere(4);
  CHECK(align(sphere, test::icosphere(3)).stability < 0.05);
  Mesh box = test::cuboid({0, 0, 0}, {1, 2, 3});
  CHECK(align(box, test::cuboid({0, 0, 0}, {1, 2, 3})).stability > 0.1);
}

TEST_CASE("meshes that cannot be aligned are refused, and stay unchanged") {
  Mesh empty, cube = test::cube(), flat = test::cube(), inside = test::cube();
  for (Vec3& p : flat.positions) p = Vec3(1, 2, 3);
  for (Face& face : inside.faces) std::swap(face[0], face[1]);
  CHECK_THROWS_AS(align(empty, cube), InputError);
  CHECK_THROWS_AS(align(cube, empty), InputError);
  CHECK_THROWS_AS(align(flat, cube), InputError);
  CHECK_THROWS_AS(align(cube, flat), InputError);
  flat.positions[0] = Vec3(2, 2, 3);
  CHECK_THROWS_WITH_AS(align(cube, flat), "the reference has no area", InputError);
  CHECK_THROWS_AS(align(cube, inside), GoalError);
  CHECK_THROWS_AS(align(cube, inside, {99, 200}), UsageError);
  CHECK_THROWS_AS(align(cube, inside, {3000, 0}), UsageError);
  CHECK(cube.positions == test::cube().positions);
}
