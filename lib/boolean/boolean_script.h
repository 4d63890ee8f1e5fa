/// Boolean operations one after the other in one process, as a text that names their operands:
///
///     # comment
///     plate = difference plate.ply hole-1.ply hole-2.ply
///     plate = union plate "a rib.ply"
///
/// An operand is a result of an earlier line, or else a file. The last line makes the result of the
/// whole. Every result is rounded, as if it were written and read again. A mesh is dropped once no
/// later line names it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/boolean.h"
#include "transformesh/errors.h"

namespace transformesh {

struct ScriptLine {
  std::size_t number = 0;  ///< in the text, from 1
  std::string result;
  BooleanOperation operation = BooleanOperation::unite;
  std::vector<std::string> operands;
};

/// union, intersection, difference and xor, in the order of the enumerators.
const std::vector<std::string>& boolean_operation_names();
/// The operation of a name, which is one of these.
BooleanOperation boolean_operation(std::string_view name);

/// Says which operands enclose nothing, and whether rounding leaves nothing of the result.
std::vector<Problem> problems_of(const BooleanResult& result,
                                 const std::vector<std::string>& names);

/// Throws InputError, naming the line, unless each says NAME = OPERATION OPERAND... and there is
/// one.
std::vector<ScriptLine> parse_boolean_script(std::string_view text);

struct ScriptResult {
  Mesh mesh;
  std::vector<Problem> problems;     ///< problems_of() the results
  std::size_t pairs = 0;             ///< intersecting pairs of faces, sum over the operations
  std::size_t rounding_repairs = 0;  ///< in all operations
  std::size_t in_place = 0;          ///< operations for which a part of the mesh was enough
  double merge_displacement = 0;     ///< a bound of how far merging moved the surface, in all
};

/// Runs the lines. `read` returns the mesh of a file. Throws as boolean() does, naming the line.
ScriptResult run_boolean_script(const std::vector<ScriptLine>& lines,
                                const std::function<Mesh(const std::string& file)>& read,
                                const BooleanOptions& options, const Progress& progress);

}  // namespace transformesh
