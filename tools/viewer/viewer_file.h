/// The viewer that pages are made of (tools/viewer), as a file beside the programs.
#pragma once

#include <string>

namespace transformesh::tool {

/// Its HTML. Throws GoalError, saying how to get it, where it was not built.
std::string read_viewer();

}  // namespace transformesh::tool
