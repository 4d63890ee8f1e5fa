/// Finds intersection-free regions: parts of a mesh in which no two faces meet outside shared
/// corners and edges. No pairs of faces are tested. A region is a disk of faces that all have
/// positive projected area in one axis direction, and whose projected outline is a simple polygon.
/// The number of faces above a point of the projection is the number of turns of the outline around
/// the point, which is one. If two parts of the region touched sideways, their outlines would
/// touch.
///
/// Reference: Volino & Magnenat-Thalmann, "Efficient self-collision detection on smoothly
/// discretized surface animations using geometrical shape regularity", Computer Graphics Forum
/// 13(3), 1994. Here regions are grown greedily instead of taken from a hierarchy, and directions
/// are the axes. Threads grow regions in blocks of faces; one thread continues with the faces that
/// are left. Hence regions depend on the number of threads. Pairs that meet do not, because all
/// regions are free of intersections.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct IntersectionFreeRegions {
  std::vector<Index> of_face;  ///< region of each face, or no_index
  std::vector<char> is_seam;   ///< 1 for each point whose faces are not all in one region
};

/// Finds the regions. O(n log n) time for sorting outlines, usually O(n); deterministic for a
/// number of threads.
IntersectionFreeRegions find_intersection_free_regions(const WeldedMesh& welded);

}  // namespace transformesh
