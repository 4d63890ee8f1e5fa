/// Finds the edges along which the exterior part of a face ends (paper 3.2.2). Each other face that
/// intersects the face does so in a segment. The winding number w in front of the face changes by a
/// known jump across each segment. Hence one known value determines w everywhere in the face. Parts
/// of segments with exterior on both sides, or on neither side, do not become edges; usually these
/// are most parts. Exact; deterministic. Cost: O(s log s + p log p) for s segments of which p pairs
/// have overlapping boxes, plus O(s) for each chain of segments that crosses no other segment.
#pragma once

#include <optional>
#include <vector>

#include "clean/exterior/segment_crossings.h"

namespace transformesh {

/// A point of the face that is on no segment, and at which the winding number w in front of the
/// face is known.
struct KnownWinding {
  ExactPoint at;
  int w;
  Index corner;  ///< corner of the face at the point, or no_index if the point is inside the face
};

/// The part of a segment between two consecutive crossings with other segments. `from` and `to` are
/// the indices of these other segments. no_index means that the part starts or ends at an end of
/// the segment itself.
struct Subsegment {
  Index segment;
  Index from, to;
  bool is_left;  ///< true if the exterior is to the left of the subsegment
};

/// Returns the parts of segments that have exterior on exactly one side, in the order of the
/// segments. A point of the face is exterior if the winding number is w < winding level in front of
/// the face and w >= winding level behind it. Returns nothing if segments touch, if three segments
/// meet in one point, or if no winding number is known. Then the caller has to cut the face along
/// all segments.
std::optional<std::vector<Subsegment>> find_bounding_subsegments(
    const ExactGeometry& geometry, const SegmentsInFace& in, const std::vector<KnownWinding>& known,
    int winding_level);

}  // namespace transformesh
