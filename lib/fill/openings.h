/// Finds openings with several border loops, such as the missing bottom of a plate that has holes.
/// An opening has an outer loop, and loops within it in the same plane that have the opposite
/// direction. If each loop had its own patch, the patches would coincide. The inner loops may be
/// off the plane if they bound islands: faces in a hole of a curved surface that no edge connects
/// with the rim of the hole. Cost: O(n) for n faces, O(n log n) to triangulate, if few boxes of
/// loops are nested. Deterministic.
#pragma once

#include "fill/hole_loops.h"

namespace transformesh {

/// Returns the loops of each hole, in order of the first loops: first the outer loop of an opening,
/// then the loops in it. Other loops are alone.
std::vector<std::vector<HoleLoop>> group_openings(const Mesh& mesh, std::vector<HoleLoop> loops);

/// Returns faces between the loops of an opening without new vertices: the constrained Delaunay
/// triangulation in the plane of the outer loop. Empty if the loops intersect in the plane,
/// or if different vertices coincide there.
std::vector<Face> triangulate_opening(const Mesh& mesh, const std::vector<HoleLoop>& loops);

}  // namespace transformesh
