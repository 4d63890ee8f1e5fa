/// Remedies that are appended to error messages and warnings of the library. The table of remedies
/// is in transformesh/_advice.py. Remedies name Python functions and arguments.
#pragma once

#include <string>
#include <vector>

#include "transformesh/errors.h"

namespace transformesh::python {

/// Returns the remedy for problems of this kind, or an empty text if there is none.
std::string advice_for(ErrorKind kind);

/// Returns the message of a problem as "message; remedy", or only the message if there is no
/// remedy.
std::string with_advice(const Problem& problem);

/// Returns for each problem its message and its remedy, in the form "message; remedy".
std::vector<std::string> with_advice(const std::vector<Problem>& problems);

}  // namespace transformesh::python
