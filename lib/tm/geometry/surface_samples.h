/// Points spread evenly over a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// `count` points, uniform by area: the surface is cut into `count` pieces of equal area in face
/// order, and each piece gets one point at random. None where the surface has no area.
/// Cost: O(faces + count). The same on every machine for the same mesh and seed.
std::vector<Vec3> surface_samples(const Mesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace transformesh
