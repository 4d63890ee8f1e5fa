/// Runs a command of the user as a filter: writes bytes to its standard input and reads its
/// standard output. The command shares stderr with this process.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

namespace transformesh::tool {

/// Kind of the command's standard output. Commands can seek in a file. The output to a file is
/// complete when the command ends, even if processes that it started still run.
enum class FilterOutput { pipe, file };

/// Runs `command` with /bin/sh and returns its output. Throws GoalError if the command cannot be
/// run, fails, or is ended by a signal. Throws UsageError or InputError if it fails with the
/// suite's exit code for these errors.
std::string run_filter(const std::string& command, std::string_view input,
                       FilterOutput output = FilterOutput::pipe);

/// Starts /bin/sh with the command in its own process group. `input` and `output` are the
/// descriptors of its standard input and output. Returns the process id. Throws GoalError if the
/// shell cannot be started.
pid_t start_shell(const std::string& command, int input, int output);

/// Throws the errors of run_filter() if `status`, from waitpid(), is not exit code 0.
void check_ending(const std::string& command, int status);

/// Throws GoalError with the message of `errno` as the reason.
[[noreturn]] void throw_not_run(const std::string& command);

}  // namespace transformesh::tool
