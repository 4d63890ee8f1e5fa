/// Samples points on a surface, uniformly by area.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct SurfacePoint {
  Index face = 0;
  Vec3 weights = Vec3::Zero();  ///< barycentric coordinates in the face; the sum is 1
  Vec3 position = Vec3::Zero();
};

/// Returns `count` points, uniform by area (stratified by faces). The total area, summed in face
/// order, is divided into `count` equal intervals. A random value in each interval selects a face,
/// and the sample is a random point on this face. Returns no points if the surface has no area.
/// Cost: O(faces + count). The result is the same on every machine for the same mesh and seed.
std::vector<Vec3> surface_samples(const Mesh& mesh, std::size_t count, std::uint64_t seed);

/// Returns the points of surface_samples() with their faces and barycentric coordinates.
std::vector<SurfacePoint> surface_points(const Mesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace transformesh
