#include <cmath>
#include <functional>
#include <numbers>

#include "helpers/shapes.h"
#include "lib/remesh/remesh_checks.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"
#include "transformesh/remesh.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

using Field = std::function<double(const Vec3&)>;

RemeshOptions within(double error) {
  RemeshOptions options;
  options.min_edge = 1e-3;
  options.max_edge = 10;
  options.adaptive_error = error;
  options.iterations = 5;
  return options;
}

/// Returns the largest value at corners, midpoints of edges and centers of faces.
double largest(const Mesh& mesh, const Field& distance) {
  double result = 0;
  for (const Face& face : mesh.faces) {
    const Vec3& a = mesh.positions[face[0]];
    const Vec3& b = mesh.positions[face[1]];
    const Vec3& c = mesh.positions[face[2]];
    for (const Vec3& p : {a, Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a)),
                          Vec3((a + b + c) / 3)}) {
      result = std::max(result, std::abs(distance(p)));
    }
  }
  return result;
}

/// Edge lengths divided by the closed form of the allowed length at their midpoints.
struct EdgeShares {
  double least = 1e300;
  double longest = 0;
  double mean = 0;

  EdgeShares(const Mesh& mesh, const Field& allowed) {
    const auto edges = edge_faces(mesh);
    for (const auto& [edge, faces] : edges) {
      const Vec3& a = mesh.positions[edge.first];
      const Vec3& b = mesh.positions[edge.second];
      const double share = (b - a).norm() / allowed(0.5 * (a + b));
      least = std::min(least, share);
      longest = std::max(longest, share);
      mean += share / static_cast<double>(edges.size());
    }
  }
};

double allowed_edge(double error, double curvature) {
  return std::sqrt(6 * error / curvature - 3 * error * error);
}

void check_sound(const Mesh& mesh, long euler) {
  CHECK(is_oriented_manifold(mesh));
  CHECK(euler_number(mesh) == euler);
  CHECK(find_intersections(mesh).empty());
  CHECK(angles(mesh).minimum_deg > 20);
}

}  // namespace

TEST_CASE("on a sphere all edges are as long as its radius and the error allow") {
  for (const double radius : {1.0, 5.0}) {
    const double error = 0.004 * radius;
    Mesh mesh = scaled(icosphere(5), radius);
    RemeshOptions options = within(error);
    options.max_edge *= radius;
    remesh(mesh, options);
    check_sound(mesh, 2);
    CHECK(largest(mesh, [=](const Vec3& p) { return p.norm() - radius; }) < error);
    const EdgeShares shares(mesh, [=](const Vec3&) { return allowed_edge(error, 1 / radius); });
    CHECK(shares.least > 0.45);
    CHECK(shares.longest < 1.05);
    CHECK(shares.mean > 0.7);
  }
}

TEST_CASE("a coarse sphere is refined as well as a fine one is coarsened") {
  Mesh mesh = icosphere(2);
  const double allowed = 0.1;
  RemeshOptions options = within(allowed * allowed / 6);
  remesh(mesh, options);
  check_sound(mesh, 2);
  const EdgeShares shares(mesh, [=](const Vec3&) { return allowed; });
  CHECK(shares.mean > 0.55);
  CHECK(shares.mean < 0.85);
}

TEST_CASE("on a torus the curvature of the tube decides") {
  const double error = 0.002;
  Mesh mesh = torus(1, 0.25, 240, 60);
  remesh(mesh, within(error));
  check_sound(mesh, 0);
  CHECK(largest(mesh, [](const Vec3& p) {
          return std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - 0.25;
        }) < error);
  const EdgeShares shares(mesh, [=](const Vec3&) { return allowed_edge(error, 4); });
  CHECK(shares.least > 0.45);
  CHECK(shares.longest < 1.05);
}

TEST_CASE("on an ellipsoid edges are short where the curvature is large") {
  const double error = 0.002;
  Mesh mesh = icosphere(6);
  for (Vec3& point : mesh.positions) point.z() *= 2;
  remesh(mesh, within(error));
  check_sound(mesh, 2);
  const auto implicit = [](const Vec3& p) {
    return p.x() * p.x() + p.y() * p.y() + p.z() * p.z() / 4;
  };
  const auto half_gradient = [](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() / 4).norm(); };
  // distance to first order, which suffices for this error
  CHECK(largest(mesh, [&](const Vec3& p) { return (implicit(p) - 1) / 2 / half_gradient(p); }) <
        error);

  // curvature is 2 at the poles, 1 along the waist
  EdgeShares shares(mesh, [&](const Vec3& p) {
    const double stretch = 4 - 3 * p.z() * p.z() / 4;
    return allowed_edge(error, std::max(2 / std::pow(stretch, 1.5), 2 / std::sqrt(stretch)));
  });
  CHECK(shares.least > 0.45);
  CHECK(shares.longest < 1.1);
  CHECK(shares.mean > 0.68);
}

TEST_CASE("lengths stay within the bounds") {
  Mesh mesh = icosphere(4);
  RemeshOptions options = within(0.05);
  options.max_edge = 0.2;  // the error would allow 0.54
  SUBCASE("from above") {
    remesh(mesh, options);
    CHECK(edge_lengths(mesh).maximum < 0.21);
    CHECK(edge_lengths(mesh).mean > 0.14);
  }
  SUBCASE("from below") {
    options.adaptive_error = 1e-6;
    options.min_edge = 0.1;
    remesh(mesh, options);
    CHECK(edge_lengths(mesh).minimum > 0.085);
    CHECK(edge_lengths(mesh).mean < 0.15);
  }
}

TEST_CASE("projected vertices lie on the input") {
  // faces of `before` are at most `depth` below the sphere
  const Mesh before = icosphere(5);
  const double depth = 1 - std::sqrt(1 - std::pow(edge_lengths(before).maximum, 2) / 3);
  RemeshOptions options;
  options.min_edge = 0.14;
  options.max_edge = 0.25;
  options.iterations = 4;
  const auto farthest_out = [&](bool project) {
    Mesh mesh = before;
    options.project = project;
    remesh(mesh, options);
    double result = 0;
    for (const Vec3& p : mesh.positions) {
      if (project) CHECK(p.norm() >= 1 - depth);
      result = std::max(result, p.norm() - 1);
    }
    return result;
  };
  CHECK(farthest_out(true) < 1e-12);
  CHECK(farthest_out(false) > 1e-3);  // without projection the volume is kept instead
}
