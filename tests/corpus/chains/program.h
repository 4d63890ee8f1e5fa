/// Runs one program as a shell would within a pipe: input on stdin, output on stdout.
#pragma once

#include <string>
#include <vector>

namespace chains {

struct ProgramLimits {
  double cpu_seconds = 20;    ///< the system ends a program that takes more
  double wall_seconds = 900;  ///< the runner ends a program that takes more
  double gigabytes = 4;       ///< of address space
};

struct ProgramResult {
  std::string output;
  std::string messages;  ///< stderr
  int exit_code = 0;     ///< 128 + the signal's number for a program that a signal ended
  double cpu_seconds = 0;
  bool is_hung = false;  ///< a limit of time ended it
};

/// Throws std::runtime_error if the program cannot be started.
ProgramResult run_program(const std::string& path, const std::vector<std::string>& arguments,
                          const std::string& input, const ProgramLimits& limits);

/// Messages without the last line end, the others replaced by slashes.
std::string in_one_line(std::string messages);

}  // namespace chains
