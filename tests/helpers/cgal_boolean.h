/// Union, intersection and difference of two closed meshes by CGAL's corefinement in exact
/// arithmetic: it shares no code with what is tested. The result is rounded to doubles at the end.
/// Both meshes must bound volumes and have no self-intersections.
/// Reference: CGAL, Polygon Mesh Processing, corefine_and_compute_boolean_operations().
#pragma once

#include "transformesh/mesh.h"

namespace transformesh::test {

struct Booleans {
  Mesh united;
  Mesh common;
  Mesh difference;  ///< the first without the second
};

/// Meshes without faces where nothing is left. Throws std::runtime_error where a result would not
/// be a manifold.
Booleans cgal_booleans(const Mesh& first, const Mesh& second);

}  // namespace transformesh::test
