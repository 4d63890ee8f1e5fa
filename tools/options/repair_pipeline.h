/// Steps of a repair as messages, and as commands of a shell.
#pragma once

#include <string>

#include "frame/run.h"
#include "transformesh/repair.h"

namespace transformesh::tool {

/// Notes each step: its program with options, what was done, where, and how area and volume
/// changed. Notes also each step that dropped more than 1 % of the area or of the volume, and
/// where.
void note_steps(const RepairResult& result, const Run& run);

/// Returns the commands that give the bytes of the output, joined by pipes. `passes_bytes`: the
/// output is the input.
std::string pipeline_of(const RepairResult& result, bool passes_bytes, const Run& run);

}  // namespace transformesh::tool
