/// Common tasks with their commands, and words that other software uses for them.
#pragma once

#include <string>
#include <string_view>

namespace transformesh::tool {

/// Returns one line for each task, with its command.
std::string list_of_jobs();

struct Alias {
  std::string_view word;     ///< name of a task in other software
  std::string_view program;  ///< program whose man page explains the task
  std::string_view command;
};

/// Returns the alias for this word of other software; null if there is none.
const Alias* alias_of(std::string_view word);

}  // namespace transformesh::tool
