/// Tori, and tubes along torus knots.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns a torus about the z axis. The grid is regular in conformal coordinates. Its triangles
/// are therefore nearly equilateral everywhere, smaller on the inner side, and all valences are
/// six. `phase` in [0, 1) shifts the grid by this fraction of a step.
Mesh torus(double ring, double tube, std::size_t faces, double phase = 0);

/// Returns two linked tori, 2.4 wide, with `gap` between their tubes (negative: overlapping).
Mesh tori(double gap, std::size_t faces);

/// Returns a tube along the knot that winds p times about the z axis and q times about a ring of
/// radius `ring`. p and q must be coprime.
Mesh torus_knot(long p, long q, double ring, double tube, std::size_t faces);

/// Returns the largest tube radius at which the knot does not touch itself. Reference:
/// Gonzalez & Maddocks, "Global curvature, thickness, and the ideal shapes of knots", PNAS 96(9),
/// 1999. O(samples^2).
double torus_knot_thickness(long p, long q, double ring);

}  // namespace transformesh::shapes
