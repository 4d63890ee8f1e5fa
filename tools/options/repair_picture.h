/// Draws a picture of a repair. The option that requests it exists only if the library was built
/// with its rendering part (`show`).
#pragma once

#include <string>

#include "frame/run.h"
#include "transformesh/repair.h"

namespace transformesh::tool {

void declare_repair_picture(Program& program, std::string& file);

/// Writes a PNG of both meshes: lost faces of the input are red, new faces of the result green.
void write_repair_picture(const Mesh& input, const RepairResult& result, const std::string& file,
                          Run& run);

}  // namespace transformesh::tool
