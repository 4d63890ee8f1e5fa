/// The main function of benchmark programs: usage, arguments and errors.
#pragma once

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <span>
#include <string>
#include <vector>

namespace transformesh {

/// Calls `measure` with the arguments. `usage` must list all of them, separated by spaces. Returns
/// the exit code: 2 if the number of arguments is wrong, 3 if `measure` throws.
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
