/// Smooth noise on surfaces.
#pragma once

#include <cstdint>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Gradient noise: smooth (C2), with mean 0, in [-1, 1], with features about one unit wide. Uses
/// only sums and products, hence the same on every machine. Reference: Perlin, "Improving noise",
/// SIGGRAPH 2002.
double smooth_noise(const Vec3& point, std::uint64_t seed);

/// Moves the vertices along normals, inwards and outwards by about `amplitude` at most, with
/// features about `wavelength` wide. Several small steps along the current normals let bumps grow,
/// overhang, and intersect each other if the amplitude is large enough.
void add_noise(Mesh& mesh, double amplitude, double wavelength, std::uint64_t seed,
               const Progress& progress);

}  // namespace transformesh::shapes
