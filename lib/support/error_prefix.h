/// Adds a prefix to the message of an error or a warning. Its kind and its data do not change.
#pragma once

#include <string>

#include "transformesh/errors.h"

namespace transformesh {

/// Returns the problem with `prefix` inserted at the beginning of its message.
Problem prefixed(const std::string& prefix, Problem problem);

/// Rethrows the current error as the same class, with `prefix` inserted at the beginning of its
/// message. An exception that is not derived from Error is rethrown unchanged.
[[noreturn]] void rethrow_with_prefix(const std::string& prefix);

}  // namespace transformesh
