/// Adds a prefix to the sentence of an error or a warning. Kind and data stay.
#pragma once

#include <string>

#include "transformesh/errors.h"

namespace transformesh {

/// Returns the problem with `prefix` before its sentence.
Problem prefixed(const std::string& prefix, Problem problem);

/// Rethrows the current error with `prefix` before its sentence, as the same class. Rethrows an
/// exception that is not an Error unchanged.
[[noreturn]] void rethrow_with_prefix(const std::string& prefix);

}  // namespace transformesh
