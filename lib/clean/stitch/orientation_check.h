/// Whether faces agree which side is outside.
///
/// What counts is their sum along an edge, those that traverse it in one direction less those that
/// run the other: 0 where the surface goes on, however many sheets meet there; 1 at the border of
/// an open surface, be it free or where a sheet ends on another surface; more where faces are
/// misoriented. Vertices are the same when their indices are. Deterministic.
#pragma once

#include <span>
#include <string>

#include "mesh/mesh.h"

namespace transformesh {

/// How many more of the halfedges are directed forward than backward. Halfedges are 3 * face +
/// corner; the forward ones go from the smaller vertex to the larger.
int sum_along(std::span<const Face> faces, std::span<const Index> halfedges);

/// The first misoriented edge in words, with its faces and its place; empty where there is none.
/// A face that names a vertex twice has no say. Cost: O(n log n).
std::string describe_misorientation(const Mesh& mesh);

}  // namespace transformesh
