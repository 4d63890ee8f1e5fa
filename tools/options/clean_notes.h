/// What programs say where faces were cut.
#pragma once

#include "frame/run.h"
#include "transformesh/clean_result.h"

namespace transformesh::tool {

/// What was dropped, what stayed, and what was decided by a small margin.
void note_cleaning(const CleanResult& result, Run& run);

}  // namespace transformesh::tool
