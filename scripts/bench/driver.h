/// What the programs that benchmarks compare with have in common: a usage, words and errors.
#pragma once

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <span>
#include <string>
#include <vector>

namespace transformesh {

/// Calls measure with the words after the program's name; `usage` says how many there are. Returns
/// the exit code: 2 where their number is another, 3 where measure throws.
inline int drive(std::span<char*> arguments, const std::string& usage,
                 const std::function<void(const std::vector<std::string>& words)>& measure) {
  const std::vector<std::string> words(arguments.begin() + 1, arguments.end());
  if (std::count(usage.begin(), usage.end(), ' ') != std::ssize(words)) {
    std::cerr << "usage: " << usage << '\n';
    return 2;
  }
  try {
    measure(words);
  } catch (const std::exception& error) {
    std::cerr << usage.substr(0, usage.find(' ')) << ": " << error.what() << '\n';
    return 3;
  }
  return 0;
}

}  // namespace transformesh
