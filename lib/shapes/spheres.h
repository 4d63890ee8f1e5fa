/// Geodesic spheres, and compositions of spheres.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns a unit sphere: each face of an icosahedron is divided into frequency^2 faces and
/// projected outwards. It has 10 n^2 + 2 vertices. Uses only square roots, hence the same on every
/// machine.
Mesh geodesic_sphere(std::size_t frequency);

/// Returns the frequency n >= 1 with 20 n^2 closest to `faces`.
std::size_t geodesic_frequency(double faces);

/// Returns the least distance of the faces of geodesic_sphere() from the center, as a fraction of
/// the radius.
double geodesic_inner_radius(std::size_t frequency);

/// Returns two spheres of this radius, `gap` apart along x (negative: overlapping).
Mesh two_spheres(double radius, double gap, std::size_t faces);

/// Returns a sphere with relief of a few percent and two round dents, 30 % and 18 % deep. The
/// bottoms of the dents are visible in no silhouette.
Mesh dented_sphere(double radius, std::size_t faces);

/// Returns `count` spheres in a ball of radius 1.2, so dense that a typical point lies in several.
Mesh many_spheres(std::size_t count, std::uint64_t seed, std::size_t faces);

}  // namespace transformesh::shapes
