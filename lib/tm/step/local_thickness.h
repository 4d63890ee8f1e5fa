/// Local thickness of a surface and of the space beside it (local feature size, but without what
/// curvature adds): at each vertex the diameter of the largest ball that touches the surface there
/// from outside or from inside and is stopped by another sheet, whose normal at the contact turns
/// away by more than 120 degrees. So gaps and walls are narrow; curved parts and edges are not.
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
/// `reach` (above 0). Of points, contacts are with points only, and diameters are too large by what
/// the samples miss.
std::vector<double> local_thickness(const Target& target, double reach,
                                    const Progress& progress = Progress());

}  // namespace transformesh
