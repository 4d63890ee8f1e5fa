/// Self-intersections of closed oriented meshes by CGAL. Shares no code with the library.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// Returns the number of pairs of faces that meet outside their common vertices and edges. Exact.
/// The mesh must be a manifold.
std::size_t count_self_intersections(const Mesh& mesh);

/// Equals count_self_intersections() without pairs that have two corners with equal positions and
/// different indices. Such pairs occur where sheets touch.
std::size_t count_self_intersections_apart(const Mesh& mesh);

}  // namespace transformesh::test
