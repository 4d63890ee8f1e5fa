/// Points spread evenly over a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct SurfacePoint {
  Index face = 0;
  Vec3 weights = Vec3::Zero();  ///< of the corners of the face; the sum is 1
  Vec3 position = Vec3::Zero();
};

/// `count` points, uniform by area: the surface is cut into `count` pieces of equal area in face
/// order, and each piece gets one point at random. None where the surface has no area.
/// Cost: O(faces + count). The same on every machine for the same mesh and seed.
std::vector<Vec3> surface_samples(const Mesh& mesh, std::size_t count, std::uint64_t seed);

/// The same points, with where they are in their faces.
std::vector<SurfacePoint> surface_points(const Mesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace transformesh
