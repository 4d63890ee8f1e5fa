/// Runs a command of the user's as a filter: bytes to its standard input, bytes from its standard
/// output; its messages go where ours do.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

namespace transformesh::tool {

/// What its standard output is: a file can be sought in, but ends with the command itself, whatever
/// that has left running.
enum class FilterOutput { pipe, file };

/// `command` is for /bin/sh. Throws GoalError where it cannot be run, fails, or is ended by a
/// signal, whatever it has written; of a command that fails, UsageError or InputError where its
/// exit code is ours for these.
std::string run_filter(const std::string& command, std::string_view input,
                       FilterOutput output = FilterOutput::pipe);

/// Starts /bin/sh with the command in a process group of its own, with these descriptors as its
/// standard input and output. Returns its process. Throws GoalError if it cannot be started.
pid_t start_shell(const std::string& command, int input, int output);

/// Throws as run_filter() does if the status of waitpid() is not that of exit code 0.
void check_ending(const std::string& command, int status);

/// Throws GoalError with the message of `errno`.
[[noreturn]] void throw_not_run(const std::string& command);

}  // namespace transformesh::tool
