/// Remedies that the command-line programs append to error messages and warnings of the library.
/// Remedies name programs and options, which the library does not know.
#pragma once

#include <span>
#include <string>

#include "frame/program.h"
#include "transformesh/errors.h"

namespace transformesh::tool {

/// A remedy for problems of one kind. Only programs that have `option` offer the remedy.
struct Advice {
  ErrorKind kind;
  const char* option;  ///< name of the option without dashes; empty: all programs offer the remedy
  /// Text of the remedy. The placeholder {name} is replaced by ErrorData::name, and {edge} by half
  /// the reference edge (the mean edge length of the initial mesh).
  const char* text;
};

/// Returns all remedies. For a problem, a program offers the first remedy for this kind of problem
/// whose option the program has.
std::span<const Advice> advice_table();

/// Returns the remedy that the program offers for the problem. Returns an empty text if there is
/// none.
std::string advice_for(const Problem& problem, const Program& program);

/// Returns the message of a problem as "message; remedy", or only the message if there is no
/// remedy.
std::string with_advice(const Problem& problem, const Program& program);

}  // namespace transformesh::tool
