/// Tori and tubes along knots.
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// About the z axis. The grid is regular in conformal coordinates, so its triangles are nearly
/// equilateral everywhere, smaller inside than outside; all valences are six.
/// `phase` in [0, 1) turns the grid by that share of a step.
Mesh torus(double ring, double tube, std::size_t faces, double phase = 0);

/// Two linked tori with `gap` between their tubes (negative: overlapping), 2.4 wide.
Mesh tori(double gap, std::size_t faces);

/// The knot that winds p times about the z axis and q times about a ring of radius `ring` around
/// it, as a tube; p and q have no common factor.
Mesh torus_knot(long p, long q, double ring, double tube, std::size_t faces);

/// The largest tube radius at which that knot does not touch itself.
/// Reference: Gonzalez & Maddocks, "Global curvature, thickness, and the ideal shapes of knots",
/// PNAS 1999.
double torus_knot_thickness(long p, long q, double ring);

}  // namespace transformesh::shapes
