/// Local thickness of a surface and of the space beside it (local feature size, but without what
/// curvature adds). At a point with a normal it is the diameter of the smallest ball that touches
/// the surface there, from outside or from inside, and touches another sheet, whose normal turns
/// away by more than 120 degrees. So gaps and walls are narrow; curved parts and edges are not. At
/// a sharp edge the normals of its faces count one by one: a slot is as narrow at its rim as
/// inside.
///
/// Balls are made smaller until no more of such a sheet lies inside than 5 % of the radius.
/// Reference: Ma, Bae & Choi, "3D medial axis point approximation using nearest neighbors and the
/// normal field", The Visual Computer 28, 2012; here with the closest points of faces, and without
/// the sheets that do not face the point.
/// Floating point; deterministic for any number of threads. Cost: O(n log n), some ten closest
/// points a vertex, in parallel.
#pragma once

#include <vector>

#include "step/target_query.h"
#include "transformesh/control.h"

namespace transformesh {

/// One diameter per vertex of the target, in input units: infinity where nothing is narrower than
/// `reach` (above 0). Of points, contacts are with points only, and diameters are too large by what
/// the samples miss.
std::vector<double> local_thickness(const Target& target, double reach,
                                    const Progress& progress = Progress());

/// The least one at the point of the target's faces that is closest to `place`, and at the corners
/// of its face nearer than `reach`. Cost: O(n).
double local_thickness_near(const TargetQuery& target, const Vec3& place, double reach);

/// The target with its thickness measured, up to `gap_edges` times `edge` (both above 0). Its faces
/// are split until no edge is longer than half of that, or of `edge` if that is more: a narrow
/// place inside a large face shows at no vertex, and one beside it is no reason for short edges all
/// over the face.
Target with_thickness(const Target& target, double gap_edges, double edge,
                      const Progress& progress = Progress());

}  // namespace transformesh
