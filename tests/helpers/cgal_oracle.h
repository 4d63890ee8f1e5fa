/// What CGAL says about closed oriented meshes: it shares no code with what is tested.
#pragma once

#include <cstddef>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// Pairs of faces that meet beyond what they share by index, exactly. The mesh must be a manifold.
std::size_t count_self_intersections(const Mesh& mesh);

/// The same without the pairs that have a corner in one place with different indices, as where
/// sheets touch.
std::size_t count_self_intersections_apart(const Mesh& mesh);

}  // namespace transformesh::test
