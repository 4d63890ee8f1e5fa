/// What --help prints, made from the table of options.
#pragma once

#include <string>

namespace transformesh::tool {

struct Command;

/// The whole help: usage, summary, own options, common options, epilogs, exit codes.
std::string help_text(const Command& command);

/// Usage, summary and where to find more: for a user who typed only the program's name.
std::string short_help_text(const Command& command);

}  // namespace transformesh::tool
