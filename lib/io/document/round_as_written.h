/// Rounds coordinates and columns to the types in which they will be written.
#pragma once

#include "transformesh/document.h"

namespace transformesh {

/// Changes a document to the result of writing it with write_mesh() as PLY and reading it with
/// read_mesh(). Hence stages in one process compute the same bytes as programs that are connected
/// by pipes. Throws GoalError as write_mesh() does.
void round_as_written(Document& document);

}  // namespace transformesh
