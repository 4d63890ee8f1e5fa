/// Remedies for problems of the library, which name programs and options.
#pragma once

#include <span>
#include <string>

#include "frame/program.h"
#include "transformesh/errors.h"

namespace transformesh::tool {

/// The remedy for problems of a kind, offered by programs that have an option.
struct Advice {
  ErrorKind kind;
  const char* option;  ///< name without dashes; empty for all programs
  const char* text;    ///< {name} becomes ErrorData::name, {edge} half the reference edge
};

/// Returns all rows. The first row of a kind whose option the program has is offered.
std::span<const Advice> advice_table();

/// Returns the remedy that this program offers; empty if it has none.
std::string advice_for(const Problem& problem, const Program& program);

/// Returns "sentence; remedy", or the sentence if there is no remedy.
std::string with_advice(const Problem& problem, const Program& program);

}  // namespace transformesh::tool
