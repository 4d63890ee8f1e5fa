/// The content of an error or of a warning, for callers that act on it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "support/error_kind.h"

namespace transformesh {

/// The facts that a sentence states, as values. A fact that it does not state is empty.
struct ErrorData {
  std::vector<std::size_t> faces = {};                  ///< indices
  std::optional<std::array<std::size_t, 2>> edge = {};  ///< indices of its vertices
  std::optional<std::array<double, 3>> position = {};   ///< input units
  std::vector<std::size_t> counts = {};                 ///< in the order of the sentence
  std::vector<double> lengths = {};                     ///< in the order of the sentence
  std::string name = {};                                ///< of a file, folder, view or argument
};

/// A sentence is one line that says what is wrong and where. It names no program and no option:
/// callers add the remedy by the kind.
struct Problem {
  ErrorKind kind = ErrorKind::other;
  std::string sentence = {};  ///< empty if there is no problem
  ErrorData data = {};
};

/// Returns the problem with `prefix` before its sentence; its kind and data stay.
Problem prefixed(const std::string& prefix, Problem problem);

}  // namespace transformesh
