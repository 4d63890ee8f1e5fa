/// Finds the parts of the segments in a face that bound its exterior (paper 3.2.2). The winding
/// number w in front of the face changes by a known jump across each segment. Hence one known value
/// determines w everywhere in the face. The other parts of the segments, usually most, do not
/// become edges. Exact; deterministic. Cost: O(s log s + p log p) for s segments of which p pairs
/// have overlapping boxes, plus O(s) for each curve of segments without crossings.
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

/// The part of a segment between two crossings. `from` and `to` are the crossing segments, or
/// no_index for the ends of the segment itself.
struct Subsegment {
  Index segment;
  Index from, to;
  bool is_left;  ///< true if the exterior is to the left of the subsegment
};

/// Returns the parts of segments that have exterior on exactly one side, in the order of the
/// segments. Exterior means the winding number w < winding level in front of the face and w >=
/// winding level behind it. Returns nothing if the face has to be cut in full: segments touch,
/// three segments meet in one point, or no winding number is known.
std::optional<std::vector<Subsegment>> find_bounding_subsegments(
    const ExactGeometry& geometry, const SegmentsInFace& in, const std::vector<KnownWinding>& known,
    int winding_level);

}  // namespace transformesh
