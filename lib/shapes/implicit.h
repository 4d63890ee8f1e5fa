/// A mesh of the surface where a function is zero, with well-shaped triangles of equal size.
/// The lattice is body-centered cubic; its points close to the surface move onto it, which leaves
/// no slivers when its tetrahedra are cut; edge flips and tangential smoothing on the surface
/// follow. Reference: Labelle & Shewchuk, "Isosurface stuffing", TOG 2007.
#pragma once

#include <functional>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// A connected solid. Its function is negative inside, never steeper than 1, and smooth near the
/// surface, where its gradient is not zero.
struct ImplicitSolid {
  std::function<double(const Vec3&)> function;
  double half_width = 1.2;  ///< it lies in the cube [-half_width, half_width]^3
  long genus = 0;           ///< of its surface
};

/// The minimum, rounded where the two differ by less than `width`. No steeper than they are.
double smooth_minimum(double a, double b, double width);

/// About `faces` triangles. Throws UsageError where that is too few for the genus, naming a number
/// that is enough. O(faces).
Mesh mesh_implicit(const ImplicitSolid& solid, std::size_t faces, const Progress& progress);

/// The point of the surface, nearly the closest, that Newton steps along the gradient lead to.
Vec3 projected(const ImplicitSolid& solid, const Vec3& point, int iterations);

}  // namespace transformesh::shapes
