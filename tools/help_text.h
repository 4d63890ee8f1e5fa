/// What --help prints, made from the table of options.
#pragma once

#include <string>
#include <vector>

#include "common_options.h"
#include "option_table.h"

namespace transformesh::tool {

/// A program as its help describes it.
struct Description {
  std::string name;
  std::string synopsis;  ///< the usage without the program's name
  std::string summary;   ///< one line without full stop
  std::string words;     ///< placeholder of the positional words, empty if there are none
  std::string words_help;
  std::vector<std::string> epilogs;
};

/// The whole help: usage, summary, own options, common options, epilogs, exit codes.
std::string help_text(const Description& program, const OptionTable& table, const Kind& kind);

/// Usage, summary and where to find more: for a user who typed only the program's name.
std::string short_help_text(const Description& program);

}  // namespace transformesh::tool
