/// Point sets for tests of wrapping, and checks that every result must pass.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "transformesh/intersect.h"
#include "transformesh/measure.h"

namespace transformesh::test {

/// Points on a surface with its normals.
struct Cloud {
  std::vector<Vec3> points, normals;
};

/// Returns points evenly spread on a unit sphere (golden spiral). Their radii vary by up to
/// `noise`.
inline Cloud sphere_cloud(int count, double noise = 0) {
  Random random(3);
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = 2.399963229728653 * i;
    const double radius = std::sqrt(1 - z * z);
    const Vec3 normal(radius * std::cos(angle), radius * std::sin(angle), z);
    cloud.points.push_back((1 + random.uniform(-noise, noise)) * normal);
    cloud.normals.push_back(normal);
  }
  return cloud;
}

/// Returns random points on a torus.
inline std::vector<Vec3> ring_points(int count) {
  Random random(1);
  std::vector<Vec3> ring;
  for (int i = 0; i < count; ++i) {
    const double u = random.uniform(0, 6.2831853);
    const double v = random.uniform(0, 6.2831853);
    const double radius = 1 + 0.3 * std::cos(v);
    ring.emplace_back(radius * std::cos(u), radius * std::sin(u), 0.3 * std::sin(v));
  }
  return ring;
}

/// Checks that a mesh is a closed oriented manifold of positive volume without self-intersections.
inline void check_surface(const Mesh& mesh) {
  const Count facts = count(mesh);
  CHECK(facts.is_closed_and_oriented);
  CHECK(facts.is_manifold);
  CHECK(find_intersections(mesh).empty());
  CHECK(volume(mesh) > 0);
}

/// Returns the points, scaled by a factor.
inline std::vector<Vec3> scaled(std::vector<Vec3> points, double factor) {
  for (Vec3& point : points) point *= factor;
  return points;
}

}  // namespace transformesh::test
