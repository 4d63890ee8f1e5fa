#include "step/morph_velocities.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/search/closest_point.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "step/prepare_target.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Returns the signed distance to a box, in closed form.
double box_distance(const Vec3& p, const Vec3& low, const Vec3& high) {
  const Vec3 beyond = (low - p).cwiseMax(p - high);
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

/// A closed mesh with edges of all directions and lengths; no two vertices are alike.
Mesh jittered_sphere(double radius, int subdivisions = 3) {
  test::Random random(3);
  Mesh mesh = test::scaled(test::icosphere(subdivisions), radius);
  for (Vec3& p : mesh.positions) p += random.point(-0.02, 0.02);
  return mesh;
}

double distance_by_search(const Vec3& p, const Mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.faces) {
    const TrianglePoint q =
        closest_point_of_triangle(p, mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    least = std::min(least, (p - q.point).norm());
  }
  return least;
}

Target points_with_normals(const Mesh& mesh) {
  Mesh points;
  points.positions = mesh.positions;
  set_normal_columns(points, vertex_normals(mesh));
  return make_target(points);
}

}  // namespace

TEST_CASE("between concentric spheres the velocity is the difference of the radii") {
  // Both spheres have the same directions, so the nearest vertex is straight above or below. Seen
  // from inside, faces are nearer than vertices, by at most their sagitta.
  const Mesh sphere = test::icosphere(3);
  const std::vector<Vec3> normals = vertex_normals(sphere);
  for (const double radius : {0.5, 0.9, 1.25, 2.0}) {
    const Target target = make_target(test::scaled(sphere, radius));
    const MorphVelocities by_vertex = morph_velocities(sphere, target, {MorphDistance::vertex});
    const MorphVelocities by_surface = morph_velocities(sphere, target, {MorphDistance::surface});
    const double sagitta = radius < 1 ? 1e-14 : 0.01 * radius;
    for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
      const Vec3& n = normals[v];
      const double along = (radius - 1) * sphere.positions[v].dot(n);
      CHECK((by_vertex.velocities[v] - along * n).norm() < 1e-14);
      CHECK((by_surface.velocities[v] - (radius - 1) * n).norm() < sagitta);
    }
    CHECK(by_vertex.to_target.rms == Approx(std::abs(radius - 1)).epsilon(1e-4));
    CHECK(by_surface.to_target.maximum == Approx(std::abs(radius - 1)).epsilon(sagitta));
  }
}

TEST_CASE("what is outside the target shrinks, what is inside grows") {
  const Target target = make_target(test::icosphere(3));
  for (const double radius : {0.3, 3.0}) {
    const Mesh mesh = test::scaled(test::icosphere(2), radius);
    for (const auto distance : {MorphDistance::surface, MorphDistance::vertex}) {
      const MorphVelocities result = morph_velocities(mesh, target, {distance});
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        CHECK((result.velocities[v].dot(mesh.positions[v]) > 0) == (radius < 1));
      }
    }
  }
}

TEST_CASE("the surface distance to a coarse box is that of the box") {
  // Twelve faces with edges far longer than the source's, and sharp edges everywhere.
  const Vec3 low(-0.6, -0.8, -1.1);
  const Vec3 high(0.7, 0.5, 0.9);
  const Target target = make_target(test::cuboid(low, high));
  const Mesh mesh = jittered_sphere(0.9);
  const MorphVelocities result = morph_velocities(mesh, target, {MorphDistance::surface});
  const std::vector<Vec3> normals = vertex_normals(mesh);
  double squares = 0;
  std::size_t inside = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double phi = box_distance(mesh.positions[v], low, high);
    CHECK((result.velocities[v] + phi * normals[v]).norm() < 1e-14);
    squares += phi * phi;
    inside += phi < 0;
  }
  CHECK(inside > 100);
  CHECK(inside < mesh.positions.size() - 100);
  CHECK(result.to_target.rms ==
        Approx(std::sqrt(squares / static_cast<double>(mesh.positions.size()))));
}

TEST_CASE("the vertex distance is the one to the tangent plane at the nearest vertex") {
  const Target target = make_target(test::torus(1, 0.4, 30, 14));
  const Mesh mesh = jittered_sphere(1.1);
  const MorphVelocities result = morph_velocities(mesh, target, {MorphDistance::vertex});
  const std::vector<Vec3> normals = vertex_normals(mesh);
  const std::vector<Vec3> target_normals = vertex_normals(target.mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    const auto nearest = std::min_element(
        target.mesh.positions.begin(), target.mesh.positions.end(),
        [&](const Vec3& a, const Vec3& b) { return (a - p).norm() < (b - p).norm(); });
    const Vec3& n =
        target_normals[static_cast<std::size_t>(nearest - target.mesh.positions.begin())];
    CHECK((result.velocities[v] - (*nearest - p).dot(n) * normals[v]).norm() < 1e-14);
  }
}

TEST_CASE("points with normals move a mesh as the mesh that they come from") {
  const Mesh torus = test::torus(1, 0.4, 40, 20);
  const Mesh mesh = jittered_sphere(1.2);
  const Target points = points_with_normals(torus);
  CHECK_FALSE(points.is_mesh());
  CHECK_FALSE(points.has_estimated_normals);
  const auto from_points = morph_velocities(mesh, points, {MorphDistance::vertex});
  const auto from_mesh = morph_velocities(mesh, make_target(torus), {MorphDistance::vertex});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    CHECK((from_points.velocities[v] - from_mesh.velocities[v]).norm() < 1e-15);
  CHECK_THROWS_AS(morph_velocities(mesh, points, {MorphDistance::surface}), UsageError);
}

TEST_CASE("the distance from the target shows a component that the mesh has lost") {
  const Mesh sphere = test::icosphere(3);
  const Mesh other = test::moved(test::scaled(sphere, 0.5), {4, 0, 0});
  const Target target = make_target(test::joined(sphere, other));
  CHECK(morph_velocities(sphere, target, {MorphDistance::surface}).to_target.maximum < 1e-12);
  const DistanceSummary lost = distance_from_target(target, sphere);
  CHECK(lost.maximum == Approx(3.5).epsilon(1e-3));
  CHECK(lost.rms > 1.5);
  CHECK(distance_from_target(target, target.mesh).maximum < 1e-12);
}

TEST_CASE("with noisy normals, several planes decide the side better than one") {
  const Vec3 axes(0.1, 0.1, 1);
  Mesh cloud;
  std::vector<Vec3> normals;
  test::Random random(4);  // estimated normals of scans are inexact
  for (const Vec3& p : test::icosphere(2).positions) {
    cloud.positions.push_back(p.cwiseProduct(axes));
    normals.push_back((p.cwiseQuotient(axes).normalized() + random.point(-1, 1)).normalized());
  }
  set_normal_columns(cloud, normals);
  const Target target = make_target(cloud);
  const auto count_inside = [&](MorphDistance distance, const Mesh& mesh) {
    // A velocity along the normal means that the vertex is inside.
    const std::vector<Vec3> outwards = vertex_normals(mesh);
    const MorphVelocities morph = morph_velocities(mesh, target, {distance});
    std::size_t count = 0;
    for (std::size_t v = 0; v < outwards.size(); ++v)
      count += morph.velocities[v].dot(outwards[v]) > 0;
    return count;
  };
  Mesh beyond = test::icosphere(3);
  for (Vec3& p : beyond.positions) p = p.cwiseProduct(Vec3(0.4, 0.4, 1.3));
  const std::size_t wrong = count_inside(MorphDistance::vertex, beyond);
  CHECK(wrong > 0);
  CHECK(count_inside(MorphDistance::points, beyond) < wrong / 4);
  Mesh within = test::icosphere(3);
  for (Vec3& p : within.positions) p = (0.5 * p).cwiseProduct(axes);
  CHECK(count_inside(MorphDistance::points, within) >= count_inside(MorphDistance::vertex, within));
}

TEST_CASE("the distance from the target is that of a search over all faces") {
  const Target target = make_target(test::torus(1, 0.4, 24, 12));
  const Mesh mesh = jittered_sphere(1.1);
  double squares = 0;
  double largest = 0;
  for (const Vec3& p : target.mesh.positions) {
    const double distance = distance_by_search(p, mesh);
    squares += distance * distance;
    largest = std::max(largest, distance);
  }
  const DistanceSummary result = distance_from_target(target, mesh);
  const auto count = static_cast<double>(target.mesh.positions.size());
  CHECK(result.rms == Approx(std::sqrt(squares / count)).epsilon(1e-3));
  CHECK(result.maximum == Approx(largest).epsilon(1e-3));
}

TEST_CASE("far away the distance is estimated, and clamped steps stay the same") {
  const Target target = make_target(test::torus(1, 0.4, 60, 30));
  const Mesh mesh = jittered_sphere(2, 4);
  const auto exact = morph_velocities(mesh, target);
  const double bound = 0.3;
  const auto fast = morph_velocities(mesh, target, {MorphDistance::surface, bound});
  std::size_t estimated = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double difference = (fast.velocities[v] - exact.velocities[v]).norm();
    const double distance = exact.velocities[v].norm();
    estimated += difference > 0;
    // The directions of `fast` and `exact` may each be wrong by a quarter of the searched distance,
    // and at least three quarters of this distance remain.
    CHECK(difference <= (distance > bound ? 2 * 0.25 / 0.75 * distance : 0));
    CHECK((fast.velocities[v].norm() > bound) == (distance > bound));
    CHECK(fast.velocities[v].dot(exact.velocities[v]) > 0);
  }
  CHECK(estimated > mesh.positions.size() / 4);
  CHECK(fast.to_target.rms == Approx(exact.to_target.rms).epsilon(0.02));

  const double from = distance_from_target(target, mesh).rms;
  CHECK(distance_from_target(target, mesh, bound).rms == Approx(from).epsilon(0.02));
}

TEST_CASE("velocities do not depend on the number of threads") {
  const Target target = make_target(test::torus(1, 0.4, 60, 30));
  const Mesh mesh = jittered_sphere(1.1);
  for (const auto distance : {MorphDistance::surface, MorphDistance::vertex}) {
    const MorphVelocities alone = [&] {
      const ThreadLimit limit(1);
      return morph_velocities(mesh, target, {distance});
    }();
    const ThreadLimit limit(4);
    const MorphVelocities together = morph_velocities(mesh, target, {distance});
    CHECK(together.velocities == alone.velocities);
    CHECK(together.to_target.rms == alone.to_target.rms);
  }
}

TEST_CASE("vertices without faces count in no distance, and do not move") {
  const Target target = make_target(test::torus(1, 0.4, 24, 12));
  const Mesh mesh = jittered_sphere(1.1);
  Mesh strewn = mesh;
  strewn.positions.emplace_back(9, 9, 9);
  strewn.positions.push_back(target.mesh.positions.front());
  for (const auto distance :
       {MorphDistance::surface, MorphDistance::vertex, MorphDistance::points}) {
    const MorphVelocities result = morph_velocities(strewn, target, {distance});
    const DistanceSummary expected = morph_velocities(mesh, target, {distance}).to_target;
    CHECK(result.to_target.rms == Approx(expected.rms));
    CHECK(result.to_target.maximum == expected.maximum);
    CHECK(result.velocities[mesh.positions.size()] == Vec3::Zero());
  }
  CHECK(distance_from_target(target, strewn).rms == distance_from_target(target, mesh).rms);
}

TEST_CASE("a mesh without faces does not move") {
  Mesh points;
  points.positions = {{0, 0, 0}};
  const Target target = make_target(test::cube());
  CHECK_THROWS_AS(morph_velocities(points, target, {MorphDistance::vertex}), InputError);
}
