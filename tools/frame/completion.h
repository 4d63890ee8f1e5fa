/// Makes completion scripts of a program's command line for bash, zsh and fish, from the same
/// options as its help. They complete names, the words of choices, files, folders, and meshes by
/// their endings.
#pragma once

#include <string>

#include "frame/program.h"

namespace transformesh::tool {

/// Returns the completion script for a shell: `bash`, `zsh` or `fish`.
std::string completion(const Program& program, const std::string& shell);

}  // namespace transformesh::tool
