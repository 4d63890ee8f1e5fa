/// Checks whether a document can be written.
#pragma once

#include "transformesh/document.h"

namespace transformesh {

/// Throws GoalError if a coordinate is not finite, or if a column does not have one value for each
/// element. O(n).
void check_writable(const Document& document);

/// Throws GoalError if a coordinate is too large for a float. O(n).
void check_float_range(const Mesh& mesh);

}  // namespace transformesh
