/// Remedies for the library's problems, in terms of programs and options.
#pragma once

#include <span>
#include <string>

#include "frame/program.h"
#include "transformesh/errors.h"

namespace transformesh::tool {

/// A row of the table: the remedy for problems of that kind, offered by programs with that option.
struct Advice {
  ErrorKind kind;
  const char* option;  ///< name without dashes; empty for all programs
  const char* text;    ///< {name} is the data's name, {edge} half the reference edge of the mesh
};

/// Returns all rows. The first row of a kind whose option the program has is offered.
std::span<const Advice> advice_table();

/// Returns the remedy that this program offers; empty if it has none.
std::string advice_for(const Problem& problem, const Program& program);

/// Returns "sentence; remedy", or the sentence if there is no remedy.
std::string with_advice(const Problem& problem, const Program& program);

}  // namespace transformesh::tool
