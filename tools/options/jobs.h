/// The jobs that people come for, and the words that other programs use for them.
#pragma once

#include <string>
#include <string_view>

namespace transformesh::tool {

/// A line for each job: what it is, and the command for it.
std::string list_of_jobs();

struct Alias {
  std::string_view word;     ///< name of the job in other programs
  std::string_view program;  ///< whose page explains it
  std::string_view command;
};

/// The alias of that word, or null.
const Alias* alias_of(std::string_view word);

}  // namespace transformesh::tool
