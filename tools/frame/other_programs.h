/// Options that users try in a program that does not have them, although another program does. The
/// error message about an unknown option suggests the other program.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace transformesh::tool {

struct OtherProgram {
  std::string_view option;   ///< name that a user tries, without dashes
  std::string_view command;  ///< program with this option, and the name of its option if it differs
};

/// Table of all such options, sorted by `option`.
extern const std::array<OtherProgram, 30> other_programs;

/// Returns the command (OtherProgram::command) that has this option or an equivalent option.
/// Returns an empty text if there is none.
std::string command_with(std::string_view option);

}  // namespace transformesh::tool
