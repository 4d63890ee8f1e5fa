/// Splits the words of a command line into options with their values, and other words. Boost's
/// library does so in native builds, and wasm/command_words.cpp does likewise without an archive of
/// Boost.
#pragma once

#include <string>
#include <vector>

#include "frame/option_set.h"

namespace transformesh::tool {

/// A known option with its value, an unknown one, or a word that is no option.
struct CommandWord {
  const Option* option = nullptr;  ///< null if the word is no option or an unknown one
  std::string text;                ///< the word as given; of an option with a value, that value
  bool is_unknown = false;         ///< `text` looks like an option and is none of the program
};

/// Takes `--name VALUE`, `--name=VALUE`, `-n VALUE`, `-nVALUE`, flags in one word (`-qv`), and `--`
/// before words that are no options. Names may not be abbreviated. Throws UsageError if a value is
/// missing, or if a flag has one.
std::vector<CommandWord> split_command(const std::vector<std::string>& arguments,
                                       const OptionSet& options);

}  // namespace transformesh::tool
