/// Spheres: geodesic ones, and several of them.
#pragma once

#include <cstdint>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// A unit sphere: each face of an icosahedron cut into frequency^2, the grid projected outwards.
/// 10 n^2 + 2 vertices. Square roots only, hence the same on every machine.
Mesh geodesic_sphere(std::size_t frequency);

/// The frequency, at least 1, whose 20 n^2 is closest to `faces`.
std::size_t geodesic_frequency(double faces);

/// How far the faces of that sphere stay from its center; 1 is the radius.
double geodesic_inner_radius(std::size_t frequency);

/// Two spheres of that radius, `gap` apart (negative: overlapping) along x.
Mesh two_spheres(double radius, double gap, std::size_t faces);

/// A sphere with relief of a few percent and two round dents, 30 % and 18 % deep: no silhouette
/// shows the bottom of those.
Mesh dented_sphere(double radius, std::size_t faces);

/// `count` spheres in a ball of radius 1.2, of which a typical point inside lies in several.
Mesh many_spheres(std::size_t count, std::uint64_t seed, std::size_t faces);

}  // namespace transformesh::shapes
