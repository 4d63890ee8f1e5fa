/// Draws inwards the parts of a surface that photographs speak against (as space carving does with
/// voxels: Kutulakos and Seitz, A theory of shape by space carving, IJCV 2000). A fin that stands
/// in a hollow since the start is so far from the truth that no step finds the way, but all views
/// that see it disagree; what lies behind it is inwards, as the start holds the object.
///
/// Where neighbors have a doubt above 0.2 vertices move along smoothed normals, at most by `depth`;
/// what no two views see stays. The surface may cross itself: clean() resolves that. Columns stay.
/// O(n); deterministic.
#pragma once

#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

/// Returns the share of the vertices that moved. `doubt`: SurfaceDoubt::of_vertex.
double carve(Mesh& mesh, const std::vector<double>& doubt, double depth);

}  // namespace transformesh
