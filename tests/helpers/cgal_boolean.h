/// Union, intersection and difference of two closed meshes by CGAL's corefinement in exact
/// arithmetic. Shares no code with the library. The results are rounded to doubles at the end.
/// Both meshes must bound volumes and have no self-intersections.
/// Reference: CGAL, Polygon Mesh Processing, corefine_and_compute_boolean_operations().
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::test {

struct Booleans {
  Mesh united;
  Mesh common;
  Mesh difference;  ///< the first mesh minus the second mesh
};

/// Empty results are meshes without faces. Throws std::runtime_error if a result would not be a
/// manifold.
Booleans cgal_booleans(const Mesh& first, const Mesh& second);

}  // namespace transformesh::test
