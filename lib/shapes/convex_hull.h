/// Convex hull of points.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh::shapes {

/// Returns the hull as triangles, computed exactly. Vertices are in the order of the points. Throws
/// InputError if all points are coplanar. O(n log n). Reference: Barber, Dobkin & Huhdanpaa, "The
/// quickhull algorithm for convex hulls", ACM TOMS 22(4), 1996, as implemented by CGAL.
Mesh convex_hull(const std::vector<Vec3>& points);

}  // namespace transformesh::shapes
