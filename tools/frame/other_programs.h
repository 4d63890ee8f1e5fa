/// Options that users try in a program that does not have them, and the programs that have them.
/// The message about an unknown option suggests such a program.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace transformesh::tool {

struct OtherProgram {
  std::string_view option;   ///< name that a user tries, without dashes
  std::string_view command;  ///< program with this option, and the name of its option if it differs
};

/// Table of these options, sorted by `option`.
extern const std::array<OtherProgram, 30> other_programs;

/// Returns the command (OtherProgram::command) that has this option or an equivalent option.
/// Returns an empty text if there is none.
std::string command_with(std::string_view option);

}  // namespace transformesh::tool
