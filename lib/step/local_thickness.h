/// Measures the local thickness of a surface and of the gaps beside it: local feature size without
/// the effect of curvature. The thickness at a point with a normal is a diameter. The smallest ball
/// that touches the surface at this point and an opposite sheet, from outside or from inside, has
/// this diameter. A sheet is opposite if its normal differs by more than 120 degrees. Gaps and
/// walls are therefore thin; curved parts and sharp edges are not. At a sharp edge the normals of
/// its faces are tested separately, so that the thickness of a slot is the same at its rim as
/// inside.
///
/// A ball shrinks until no opposite sheet reaches deeper into it than 5 % of its radius. Reference:
/// Ma, Bae & Choi, "3D medial axis point approximation using nearest neighbors and the normal
/// field", The Visual Computer 28, 2012. Departures: contacts are closest points on faces instead
/// of sample points, and sheets that are not opposite are ignored. Floating point; deterministic
/// for any number of threads. Cost: O(n log n), about ten closest-point queries per vertex, in
/// parallel.
#pragma once

#include <vector>

#include "step/target_query.h"
#include "transformesh/control.h"

namespace transformesh {

/// Sides of the surface on which balls are placed.
enum class BallSides { both, inside };

/// Returns the local thickness at each vertex of the target in input units, or infinity if it is
/// not less than `reach`. Pre: `reach` > 0. If the target is a point set, the balls touch points
/// instead of faces. The thickness is then too large by an amount that depends on the sampling
/// density. Gaps do not count if `sides` is `inside`.
std::vector<double> local_thickness(const Target& target, double reach,
                                    const Progress& progress = Progress(),
                                    BallSides sides = BallSides::both);

/// Returns the least local thickness near `place`. It is measured at the closest point on the
/// target's faces, and at those corners of its face that are closer to `place` than `reach`. Cost:
/// O(n).
double local_thickness_near(const TargetQuery& target, const Vec3& place, double reach);

/// Returns the target with its thickness measured up to `gap_edges` * `edge`; both must be > 0.
/// Faces are first split until no edge is longer than half of the larger of `edge` and `gap_edges`
/// * `edge`. Without the split, a narrow place inside a large face would be at no vertex, and a
/// narrow place at a corner would count for the whole face.
Target with_thickness(const Target& target, double gap_edges, double edge,
                      const Progress& progress = Progress());

}  // namespace transformesh
