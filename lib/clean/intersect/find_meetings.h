/// Finds all pairs of intersecting faces of a welded mesh, with their contacts (contacts.h).
/// Cost: O(n log n + k) for k pairs of overlapping boxes. Parallel; deterministic.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "clean/intersect/disjoint_faces.h"
#include "transformesh/control.h"
#include "transformesh/intersect.h"

namespace transformesh {

struct Meeting;
struct WeldedMesh;

/// Finds the pairs that find_intersections() of intersect.h finds. Copies are faces with the same
/// three points. Only the first of several copies appears in the result, and pairs of copies of one
/// face are not listed. Two faces of `disjoint` are not tested with each other.
std::vector<Meeting> find_meetings(const WeldedMesh& welded, const Progress& progress,
                                   const DisjointFaces& disjoint = {});

/// Returns what find_intersections() of intersect.h returns. Two faces of `disjoint` are not tested
/// with each other.
std::vector<FacePair> find_intersections(const Mesh& mesh, const DisjointFaces& disjoint,
                                         const Progress& progress);

/// Returns what find_meetings() returns, if `pairs` are the intersecting pairs of faces of the mesh
/// that was welded. Cost: O(k log n) for k pairs.
std::vector<Meeting> meetings_of(const WeldedMesh& welded, std::span<const FacePair> pairs);

/// Returns the number of intersecting pairs of faces. Coincident faces, which `meetings` lists
/// once, are counted separately, and intersect each other.
std::size_t count_pairs(const WeldedMesh& welded, const std::vector<Meeting>& meetings);

}  // namespace transformesh
