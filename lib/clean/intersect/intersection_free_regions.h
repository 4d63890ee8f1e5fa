/// Finds intersection-free regions: parts of a mesh in which no two faces meet outside shared
/// corners and edges. No pairs of faces are tested. A region is a disk of faces that all have
/// positive projected area in one axis direction, and whose projected outline is a simple polygon.
/// The number of faces that are projected onto a point inside the outline is the winding number of
/// the projected outline around the point, which is 1. If two parts of the region touched sideways,
/// their projected outlines would touch.
///
/// Reference: Volino & Magnenat-Thalmann, "Efficient self-collision detection on smoothly
/// discretized surface animations using geometrical shape regularity", Computer Graphics Forum
/// 13(3), 1994. Here regions are grown greedily instead of taken from a hierarchy, and directions
/// are the axes. Threads grow regions in blocks of consecutive faces; afterwards one thread grows
/// regions of the faces that are left. Hence the regions depend on the number of threads. The
/// intersecting pairs that the search finds do not, because no region contains an intersection.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct IntersectionFreeRegions {
  std::vector<Index> of_face;  ///< region of each face, or no_index
  std::vector<char> is_seam;   ///< 1 for each point whose faces are not all in one region
};

/// Finds the regions. Cost: O(n log n) in the worst case, for sorting outlines; usually O(n). The
/// result depends only on the mesh and the number of threads.
IntersectionFreeRegions find_intersection_free_regions(const WeldedMesh& welded);

}  // namespace transformesh
