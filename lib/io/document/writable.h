/// Checks whether a document can be written.
#pragma once

#include "transformesh/document.h"

namespace transformesh {

/// Throws GoalError if a coordinate is not finite, or if a column does not have one value for each
/// element. O(n).
void check_writable(const Document& document);

}  // namespace transformesh
