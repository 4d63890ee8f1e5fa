/// Smooth noise on surfaces.
#pragma once

#include <cstdint>

#include "mesh/mesh.h"
#include "support/progress.h"

namespace transformesh::shapes {

/// Gradient noise: smooth (C2), 0 on average, within [-1, 1], with bumps about one unit wide. Sums
/// and products only, hence the same on every machine.
/// Reference: Perlin, "Improving noise", SIGGRAPH 2002.
double smooth_noise(const Vec3& point, std::uint64_t seed);

/// Moves the vertices along the normals of the surface as it moves, by up to about `amplitude`
/// there and back, with bumps about `wavelength` wide. In several steps, so that what bulges bulges
/// on, and overhangs and intersects itself where the amplitude is large enough.
void add_noise(Mesh& mesh, double amplitude, double wavelength, std::uint64_t seed,
               const Progress& progress);

}  // namespace transformesh::shapes
