/// Which parts of the segments in a face bound what is exterior of it (paper 3.2.2): where w in
/// front of the face is known at one point, it is known everywhere, as every segment changes it by
/// a step. The other parts, usually most, need not become edges. Exact; deterministic. Cost: O(s
/// log s + p log p) for s segments of which p pairs have boxes that overlap, and O(s) for each of
/// their curves that no other crosses.
#pragma once

#include <optional>
#include <vector>

#include "clean/exterior/segment_crossings.h"

namespace transformesh {

/// A point of the face at which w in front is known; it is on no segment.
struct KnownWinding {
  ExactPoint at;
  int w;
  Index corner;  ///< that it is, or no_index for one inside the face
};

/// The part of a segment between two points: those where other segments cross it, or its own ends
/// where they are no_index.
struct Subsegment {
  Index segment;
  Index from, to;
  bool is_left;  ///< whether what is exterior is on its left
};

/// The parts that have w < winding level in front and w >= winding level behind the face on just
/// one side, in the order of the segments. Nothing if crossings alone do not decide that: where
/// segments touch, or three meet in one point, or no winding number is known.
std::optional<std::vector<Subsegment>> find_bounding_subsegments(
    const ExactGeometry& geometry, const SegmentsInFace& in, const std::vector<KnownWinding>& known,
    int winding_level);

}  // namespace transformesh
