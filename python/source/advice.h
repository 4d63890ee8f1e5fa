/// Remedies for problems of the library, which name Python functions and arguments: the table of
/// transformesh/_advice.py.
#pragma once

#include <string>
#include <vector>

#include "transformesh/errors.h"

namespace transformesh::python {

/// Returns the remedy for problems of that kind; empty if there is none.
std::string advice_for(ErrorKind kind);

/// Returns "sentence; remedy", or the sentence if there is no remedy.
std::string with_advice(const Problem& problem);

/// Returns the lines of with_advice().
std::vector<std::string> with_advice(const std::vector<Problem>& problems);

}  // namespace transformesh::python
