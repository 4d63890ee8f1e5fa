/// Runs a command of the user's as a filter: bytes to its standard input, bytes from its standard
/// output; its messages go where ours do.
#pragma once

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

}  // namespace transformesh::tool
