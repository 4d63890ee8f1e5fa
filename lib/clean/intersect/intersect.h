/// Self-intersections (paper 3.1): all pairs of faces that meet anywhere but in corners and edges
/// that they share. Sharing means equal coordinates, not equal indices. Touching counts: a corner
/// on a face or an edge, two edges that cross or overlap, coplanar overlaps, coincident faces.
/// Faces without area take no part. Exact for any finite coordinates. Where the paper sweeps boxes
/// and perturbs what touches (4.3), this leaves out what cannot meet (intersection_free_regions.h,
/// faces_to_search.h), searches a bounding volume hierarchy of the rest, and perturbs nothing.
/// Cost: O(n log n + k) for k pairs on usual meshes; parallel; the result is sorted and does not
/// depend on the number of threads.
#pragma once

#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "support/progress.h"

namespace transformesh {

struct Meeting;
struct WeldedMesh;

using FacePair = std::pair<Index, Index>;

/// Pairs of face indices, first < second, sorted.
std::vector<FacePair> find_intersections(const Mesh& mesh, const Progress& progress = Progress());

/// The same for the faces of a welded mesh, with their contacts. The first of equal faces stands
/// for its copies: k of them are no pairs here.
std::vector<Meeting> find_meetings(const WeldedMesh& welded, const Progress& progress);

/// How many pairs these are when every copy counts.
std::size_t count_pairs(const WeldedMesh& welded, const std::vector<Meeting>& meetings);

/// The common segments of the intersecting pairs as end points, in the order of the pairs. Where
/// two faces only touch in a point both ends are equal. Coplanar pairs contribute none.
std::vector<std::pair<Vec3, Vec3>> intersection_segments(const Mesh& mesh,
                                                         const std::vector<FacePair>& pairs);

}  // namespace transformesh
