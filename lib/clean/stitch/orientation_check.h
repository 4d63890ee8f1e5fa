/// Checks whether faces are consistently oriented.
///
/// The criterion is the sum along each edge: the number of faces that traverse the edge in one
/// direction minus the number in the opposite direction. The sum is 0 if all surfaces continue
/// across the edge, however many meet there. The sum is 1 or -1 if one surface ends at the edge,
/// with or without other surfaces there. A larger absolute value means that faces are misoriented.
/// Vertices are equal if their indices are. Deterministic.
#pragma once

#include <span>
#include <string>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the number of forward halfedges of an edge minus the number of backward ones. A halfedge
/// 3 * face + corner is forward if it runs from the smaller to the larger vertex index.
int sum_along(std::span<const Face> faces, std::span<const Index> halfedges);

/// Describes the first misoriented edge: the faces that traverse it in the same direction, its
/// coordinates, and the number of all misoriented edges. The sentence is empty if no edge is
/// misoriented. Ignores faces that refer to a vertex twice. Cost: O(n log n).
Problem find_misorientation(const Mesh& mesh);

std::string describe_misorientation(const Mesh& mesh);

}  // namespace transformesh
