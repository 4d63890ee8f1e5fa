/// Rounds coordinates and columns to the types in which they will be written.
#pragma once

#include "transformesh/document.h"

namespace transformesh {

/// Changes a document to the result of write_mesh() in a PLY format and read_mesh(). Stages in one
/// process then compute the same bytes as programs on pipes. Throws GoalError as write_mesh() does.
void round_as_written(Document& document);

}  // namespace transformesh
