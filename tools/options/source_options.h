/// Options on how calibrated photographs are read.
#pragma once

#include "frame/program.h"
#include "transformesh/views.h"

namespace transformesh::tool {

/// Declares --mirror and --missing.
void declare_reading(Program& program, ViewSources& sources);

}  // namespace transformesh::tool
