/// Normals for points that have none: each is the direction of least spread of its neighbors
/// (principal component analysis), and neighbors are turned to agree along a spanning tree that
/// crosses sharp bends last. Reference: Hoppe et al., "Surface reconstruction from unorganized
/// points", SIGGRAPH 1992.
///
/// Where the neighborhoods fall into several groups, each is turned outwards on its own at its
/// highest point, so a cavity comes out reversed. Right where points sample a closed surface more
/// densely than its sheets are apart. Floating point; deterministic. Cost: O(k n log n).
#pragma once

#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Unit normals, one per point; zero where all neighbors coincide. `neighbors`, at least 3,
/// is how many others a point looks at. Throws InputError for fewer than four points.
std::vector<Vec3> estimate_normals(std::span<const Vec3> points, std::size_t neighbors = 12);

}  // namespace transformesh
