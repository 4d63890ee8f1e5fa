/// Runs a command of the user's as a filter: bytes to its standard input, bytes from its standard
/// output; its messages go where ours do.
#pragma once

#include <string>
#include <string_view>

namespace transformesh::tool {

/// `command` is for /bin/sh. Throws GoalError where it cannot be run, fails, or is ended by a
/// signal, whatever it has written; of a command that fails, UsageError or InputError where its
/// exit code is ours for these.
std::string run_filter(const std::string& command, std::string_view input);

}  // namespace transformesh::tool
