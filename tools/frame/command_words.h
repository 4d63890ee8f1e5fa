/// Splits the words of a command line into options with their values, and other words. Native
/// builds use Boost.ProgramOptions. WebAssembly builds use wasm/command_words.cpp, which needs no
/// compiled part of Boost.
#pragma once

#include <string>
#include <vector>

#include "frame/option_set.h"

namespace transformesh::tool {

/// A known option with its value, an unknown option, or a word that is no option.
struct CommandWord {
  const Option* option = nullptr;  ///< null if the word is no option or an unknown option
  std::string text;                ///< value of an option that has one; otherwise the word as given
  /// True if `text` looks like an option that the program does not have.
  bool is_unknown = false;
};

/// Accepts `--name VALUE`, `--name=VALUE`, `-n VALUE`, `-nVALUE`, several flags in one word
/// (`-qv`), and `--` before words that are no options. Names may not be abbreviated. Throws
/// UsageError if a value is missing, or if a flag has one.
std::vector<CommandWord> split_command(const std::vector<std::string>& arguments,
                                       const OptionSet& options);

}  // namespace transformesh::tool
