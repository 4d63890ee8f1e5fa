/// Computes the wanted edge length (size) at every vertex, from a column of the mesh or from
/// curvature.
#pragma once

#include <string>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// Returns the values of a vertex column. Throws InputError if the column does not exist or a value
/// is not a positive number.
std::vector<double> sizes_of_column(const Mesh& mesh, const std::string& column);

struct SizeBounds {
  double error = 0;     ///< largest distance of faces from the curved surface; input units, > 0
  double shortest = 0;  ///< smallest size, > 0
  double longest = 0;   ///< largest size, >= shortest
};

/// Returns sizes by curvature k (curvature.h), clamped to the bounds. A size is the longest edge of
/// an equilateral triangle that stays within `error` of the sphere of curvature k through its
/// corners: L = sqrt(6 error / k - 3 error^2). Reference: Dunyach, Vanderhaeghe, Barthe & Botsch,
/// "Adaptive remeshing for real-time mesh deformation", Eurographics 2013 short papers.
std::vector<double> sizes_of_curvature(const EditableMesh& mesh, const SizeBounds& bounds);

/// Limits the gradient of sizes: reduces sizes until neighbors differ by at most 0.3 of the length
/// of their edge. If an edge has the wanted length, the sizes of its ends differ by at most 30 %.
/// Reference: Persson, "Mesh size functions for implicit geometries and PDE-based gradient
/// limiting", Engineering with Computers 22, 2006. O(n log n).
void grade_sizes(const EditableMesh& mesh, std::vector<double>& sizes);

}  // namespace transformesh
