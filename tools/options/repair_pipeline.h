/// Describes the steps of a repair in messages and as shell commands.
#pragma once

#include <string>

#include "frame/run.h"
#include "transformesh/repair.h"

namespace transformesh::tool {

/// Prints for each step of a repair its command, the defects found, a position, and the changes of
/// area and volume. Also prints a note, with the position, for each step that lost more than 1 % of
/// the area or of the volume.
void note_steps(const RepairResult& result, const Run& run);

/// Returns a pipeline of commands that writes the same bytes as the output. `passes_bytes` is true
/// if the output equals the input.
std::string pipeline_of(const RepairResult& result, bool passes_bytes, const Run& run);

}  // namespace transformesh::tool
