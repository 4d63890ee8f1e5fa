/// Estimates normals of points. Each normal is the direction of least variance of the neighbors of
/// the point (principal component analysis). Signs are propagated along a minimum spanning tree of
/// the neighborhood graph, whose edges cost more if the two normals differ more. Reference: Hoppe,
/// DeRose, Duchamp, McDonald & Stuetzle, "Surface reconstruction from unorganized points", SIGGRAPH
/// 1992.
///
/// Each connected component of the graph gets an upward normal at its highest point, so that the
/// normals around a cavity are reversed. Signs are right if the points sample a closed surface, and
/// if they are closer to each other than the sheets of the surface are. Floating point;
/// deterministic. Cost: O(k n log n) for k neighbors.
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns a unit normal per point, or zero if all its neighbors coincide. `neighbors` is the
/// number of other points in a neighborhood, at least 3. Throws InputError for fewer than four
/// points.
std::vector<Vec3> estimate_normals(std::span<const Vec3> points, std::size_t neighbors = 12);

}  // namespace transformesh
