/// A conservative test for contact of two triangles: rounding errors count as contact.
/// Two triangles are certainly apart when a plane separates them with a margin far above rounding
/// error; which plane is tried does not matter for that certainty. Corners are the same when their
/// coordinates are equal.
#pragma once

#include "mesh/triangle.h"

namespace transformesh {

/// False only where the triangles certainly share no point beyond common corners and the edge
/// between two common corners. True for contact, for near contact within rounding, for faces that
/// fold onto each other across a common edge (closer than a thousandth of a radian), for equal
/// triangles and next to triangles without area.
bool may_touch(const Triangle& first, const Triangle& second);

}  // namespace transformesh
