/// Helpers for the tests of lib/clean/exterior and lib/clean/open: arrangements of intersecting
/// shapes, and winding numbers close to triangles, which are computed by summing solid angles.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <optional>

#include "clean/arrange/arrange.h"
#include "clean/exterior/exterior_arrangement.h"
#include "clean/intersect/find_meetings.h"
#include "helpers/mesh_facts.h"
#include "helpers/random.h"
#include "helpers/shapes.h"
#include "mesh/triangle.h"

namespace transformesh::test {

inline Arrangement arranged(const Mesh& mesh) {
  const auto welded = std::make_shared<const WeldedMesh>(weld(mesh));
  return arrange(welded, find_meetings(*welded, Progress()), Progress());
}

/// Returns the arrangement that cleaning computes for a mesh with open components.
/// `component_of_face` has the open component of each face (WeldedMesh::open_component).
inline Arrangement arranged_open(const Mesh& mesh, std::vector<Index> component_of_face) {
  const auto welded = std::make_shared<WeldedMesh>(weld(mesh));
  welded->open_component = std::move(component_of_face);
  const std::vector<Meeting> meetings = find_meetings(*welded, Progress());
  return arrange_exterior(welded, meetings, {1, false, nullptr}, Progress()).arrangement;
}

/// Returns balls around random points; every third one is inside out.
inline Mesh random_balls(std::uint64_t seed, int count) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Mesh ball = moved(scaled(icosphere(1), random.uniform(0.4, 1)), random.point(-0.8, 0.8));
    mesh = joined(mesh, i % 3 == 2 ? reversed(ball) : ball);
  }
  return mesh;
}

inline Triangle corners_of(const Arrangement& arrangement, const Piece& piece) {
  const auto& [a, b, c] = piece.corners;
  return {arrangement.position(a), arrangement.position(b), arrangement.position(c)};
}

/// Returns the winding number of a closed mesh in front of a triangle (`side` 1) or behind it
/// (`side` -1). Returns nothing for slivers, because every point near a sliver may be near other
/// faces, too.
inline std::optional<int> winding_beside(const Mesh& mesh, const Triangle& t, int side) {
  const Vec3 normal = normal_of(t[0], t[1], t[2]);
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, (t[(i + 1) % 3] - t[i]).norm());
  const double height = normal.norm() / longest;
  if (height < 1e-3) return std::nullopt;
  const Vec3 point = (t[0] + t[1] + t[2]) / 3 + side * 1e-7 * height * normal.normalized();
  const double winding = winding_number(mesh, point);
  const int rounded = static_cast<int>(std::lround(winding));
  return std::abs(winding - rounded) < 1e-6 ? std::optional(rounded) : std::nullopt;
}

}  // namespace transformesh::test
