/// Reads the viewer (tools/viewer), an HTML file that is installed with the programs.
#pragma once

#include <string>

namespace transformesh::tool {

/// Returns the HTML of the viewer. Throws GoalError with a remedy if the viewer was not built.
std::string read_viewer();

}  // namespace transformesh::tool
