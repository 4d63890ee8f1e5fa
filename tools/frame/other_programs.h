/// Options that users look for in the wrong program.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace transformesh::tool {

struct OtherProgram {
  std::string_view option;   ///< without dashes
  std::string_view command;  ///< a program, and its option if that has another name
};

/// In the order of the options.
extern const std::array<OtherProgram, 30> other_programs;

/// The program with this option or what it means, or an empty text.
std::string command_with(std::string_view option);

}  // namespace transformesh::tool
