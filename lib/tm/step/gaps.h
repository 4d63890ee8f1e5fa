/// How narrow a surface is at each of its vertices: the diameter of the largest ball that touches
/// it there from outside or from inside and is stopped by another sheet, whose normal at the
/// contact turns away by more than 120 degrees. Gaps between sheets and the thickness of walls are
/// narrow places; curved ones and edges are not.
///
/// Balls are made smaller until no more of the surface lies inside than 5 % of the radius.
/// Reference: Ma, Bae & Choi, "3D medial axis point approximation using nearest neighbors and the
/// normal field", The Visual Computer 28, 2012; here with the closest points of faces.
/// Floating point; deterministic for any number of threads. Cost: O(n log n), some ten closest
/// points a vertex, in parallel.
#pragma once

#include <vector>

#include "tm/step/target.h"
#include "tm/support/progress.h"

namespace transformesh {

/// One diameter per vertex of the target, in input units: infinity where nothing is narrower than
/// `reach` (above 0). Of points, contacts are with points only, and diameters too large by what the
/// samples miss.
std::vector<double> gap_widths(const Target& target, double reach,
                               const Progress& progress = Progress());

}  // namespace transformesh
