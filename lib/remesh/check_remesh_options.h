/// Checks the options of remeshing without a mesh.
#pragma once

#include "transformesh/remesh_options.h"

namespace transformesh {

/// Throws UsageError for options out of range.
void check_options(const RemeshOptions& options);

}  // namespace transformesh
