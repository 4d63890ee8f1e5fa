/// Makes contacts of what is close (paper 4.3): where two faces intersect, and a corner of one is
/// within a few spacings of numbers of the other face, that face is split at the corner; where two
/// edges pass each other that closely, both are split at one new vertex. So the sheets on both
/// sides of a thin sheet come to share their corners, until cleaning can decide what lies between
/// them. What is closed stays closed. Deterministic. O(n log n + k) for k intersecting pairs.
/// Reference for the plane: Hobby, "Practical segment intersection with finite precision output",
/// Computational Geometry 13(4), 1999.
#pragma once

#include <utility>
#include <vector>

#include "clean/rounding/displacement.h"
#include "clean/rounding/local_distance.h"
#include "clean/stitch/assemble.h"
#include "transformesh/intersect.h"

namespace transformesh {

/// Equal positions have equal indices; intersections are those of find_broken_faces(). A face is
/// split once; others of its contacts are left to a further call. Returns how far a surface moved,
/// more than zero spacings where a face was split.
Displacement split_at_contacts(Assembly& assembly, const std::vector<FacePair>& intersections,
                               double spacings, const Spacings& spacing);

}  // namespace transformesh
