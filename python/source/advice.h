/// Remedies for problems of the library, from the table in transformesh/_advice.py. The remedies
/// name Python functions and arguments.
#pragma once

#include <string>
#include <vector>

#include "transformesh/errors.h"

namespace transformesh::python {

/// Returns the remedy for problems of this kind, or an empty text if there is none.
std::string advice_for(ErrorKind kind);

/// Returns "sentence; remedy", or the sentence if there is no remedy.
std::string with_advice(const Problem& problem);

/// Returns "sentence; remedy" for each problem, as the function above.
std::vector<std::string> with_advice(const std::vector<Problem>& problems);

}  // namespace transformesh::python
