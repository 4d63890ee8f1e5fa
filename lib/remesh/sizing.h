/// The edge length wanted at every vertex: from a column of the mesh, or from curvature.
#pragma once

#include <string>
#include <vector>

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

/// The column's values. Throws InputError where there is none of that name or a value is not a
/// positive number.
std::vector<double> sizes_of_column(const Mesh& mesh, const std::string& column);

struct SizeBounds {
  double error = 0;     ///< of the surface between the vertices; input units, > 0
  double shortest = 0;  ///< least size, > 0
  double longest = 0;   ///< largest, >= shortest
};

/// The longest edge of an equilateral triangle that keeps within `error` of a sphere of curvature
/// k through its corners: L = sqrt(6 error / k - 3 error^2) (Dunyach et al., "Adaptive remeshing
/// for real-time mesh deformation", Eurographics 2013 short papers), within the bounds; k as in
/// curvature.h.
std::vector<double> sizes_of_curvature(const EditableMesh& mesh, const SizeBounds& bounds);

/// Lowers sizes until none is larger than a neighbor's by more than 0.3 of the edge between them
/// (as in Persson, "Mesh size functions for implicit geometries and PDE-based gradient limiting",
/// Engineering with Computers 2006): across an edge of that length, sizes differ by at most 30 %.
/// O(n log n).
void grade_sizes(const EditableMesh& mesh, std::vector<double>& sizes);

}  // namespace transformesh
