/// Runs one program as a shell would in a pipe: input on stdin, output on stdout.
#pragma once

#include <string>
#include <vector>

namespace chains {

struct ProgramLimits {
  double cpu_seconds = 20;    ///< limit of CPU time, which the system enforces
  double wall_seconds = 900;  ///< limit of elapsed time, which the runner enforces
  double gigabytes = 4;       ///< limit of the address space
};

struct ProgramResult {
  std::string output;
  std::string messages;  ///< stderr
  int exit_code = 0;     ///< exit code; 128 + the signal's number if a signal ended the program
  double cpu_seconds = 0;
  bool is_hung = false;  ///< the program was ended by a limit of time
};

/// Throws std::runtime_error if the program cannot be started.
ProgramResult run_program(const std::string& path, const std::vector<std::string>& arguments,
                          const std::string& input, const ProgramLimits& limits);

/// Returns stderr as one line: line breaks within are replaced by slashes.
std::string in_one_line(std::string messages);

}  // namespace chains
