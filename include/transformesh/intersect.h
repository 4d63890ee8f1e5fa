/// Finds self-intersections (paper 3.1): all pairs of faces that meet outside their common corners
/// and edges. Two faces share a corner if its coordinates are equal, regardless of the indices.
/// Touching counts: a corner on a face or an edge, two edges that intersect or overlap, coplanar
/// overlaps, coincident faces. Faces without area are ignored.
///
/// Exact for any finite coordinates. The paper sweeps boxes and perturbs contacts (4.3). This
/// search leaves out faces that cannot meet, searches a bounding volume hierarchy of the others,
/// and perturbs nothing. Cost: O(n log n + k) for k pairs on usual meshes. Parallel; deterministic
/// for any number of threads.
#pragma once

#include <utility>
#include <vector>

#include "transformesh/control.h"
#include "transformesh/mesh.h"

namespace transformesh {

using FacePair = std::pair<Index, Index>;

/// Returns the pairs of faces that intersect: indices with first < second, sorted.
std::vector<FacePair> find_intersections(const Mesh& mesh, const Progress& progress = Progress());

/// Returns the segments in which the given pairs of faces intersect, in the order of the pairs.
/// Both ends are equal if two faces touch only in a point. Coplanar pairs have no segment.
std::vector<std::pair<Vec3, Vec3>> intersection_segments(const Mesh& mesh,
                                                         const std::vector<FacePair>& pairs);

}  // namespace transformesh
