/// Whether faces agree which side is outside.
///
/// What counts is their sum along an edge, those that traverse it in one direction less those that
/// run the other: 0 where the surface goes on, however many sheets meet there; 1 at the border of
/// an open surface, be it free or where a sheet ends on another surface; more where faces are
/// misoriented. Vertices are the same when their indices are. Deterministic.
#pragma once

#include <span>
#include <string>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// How many more of the halfedges are directed forward than backward. Halfedges are 3 * face +
/// corner; the forward ones go from the smaller vertex to the larger.
int sum_along(std::span<const Face> faces, std::span<const Index> halfedges);

/// Returns the first misoriented edge, with the faces that run along it the same way, its place and
/// the number of such edges; an empty sentence if there is none. Ignores faces that name a vertex
/// twice. Cost: O(n log n).
Problem find_misorientation(const Mesh& mesh);

/// Returns the sentence of find_misorientation().
std::string describe_misorientation(const Mesh& mesh);

}  // namespace transformesh
