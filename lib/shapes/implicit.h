/// Meshes the zero set of a function with well-shaped triangles of equal size. Points of a
/// body-centered cubic lattice that are close to the surface are moved onto it, which avoids
/// slivers when the tetrahedra are cut. Edge flips and tangential smoothing on the surface follow.
/// Reference: Labelle & Shewchuk, "Isosurface stuffing: fast tetrahedral meshes with good dihedral
/// angles", TOG 26(3), 2007. O(faces).
#pragma once

#include <functional>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// A connected solid. The function is negative inside, its slope is at most 1, and it is smooth
/// with a nonzero gradient near the surface.
struct ImplicitSolid {
  std::function<double(const Vec3&)> function;
  double half_width = 1.2;  ///< the solid lies in [-half_width, half_width]^3
  long genus = 0;           ///< genus of the surface
};

/// Returns a smooth minimum: the kink at a = b is rounded off where a and b differ by less than
/// `width`. The slope is not increased.
double smooth_minimum(double a, double b, double width);

/// Returns a mesh of about `faces` triangles. Throws UsageError if these are too few for the genus,
/// and states a sufficient number. O(faces).
Mesh mesh_implicit(const ImplicitSolid& solid, std::size_t faces, const Progress& progress);

/// Moves a point onto the surface by Newton steps along the gradient. The result is nearly the
/// closest point.
Vec3 projected(const ImplicitSolid& solid, const Vec3& point, int iterations);

}  // namespace transformesh::shapes
