/// Prints notes about the result of removing self-intersections. Used by all programs that cut
/// faces.
#pragma once

#include "frame/run.h"
#include "transformesh/clean_result.h"

namespace transformesh::tool {

/// Prints notes about dropped and kept parts, and about decisions between inside and outside by a
/// small margin.
void note_cleaning(const CleanResult& result, Run& run);

}  // namespace transformesh::tool
