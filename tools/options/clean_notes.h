/// Notes of programs that cut faces.
#pragma once

#include "frame/run.h"
#include "transformesh/clean_result.h"

namespace transformesh::tool {

/// Says on stderr what was dropped, what stayed, and what was decided by a small margin.
void note_cleaning(const CleanResult& result, Run& run);

}  // namespace transformesh::tool
