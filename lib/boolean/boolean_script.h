/// Runs a script of Boolean operations in one process. Each line names a result, an operation and
/// its operands:
///
///     # comment
///     plate = difference plate.ply hole-1.ply hole-2.ply
///     plate = union plate "a rib.ply"
///
/// An operand is the result of an earlier line; if no earlier line has that name, it is a file. The
/// result of the last line is the result of the script. Every result is rounded as if it were
/// written to a file and read again. The memory of a mesh is freed when no later line names it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/boolean.h"
#include "transformesh/errors.h"

namespace transformesh {

struct ScriptLine {
  std::size_t number = 0;  ///< line number in the text, from 1
  std::string result;
  BooleanOperation operation = BooleanOperation::unite;
  std::vector<std::string> operands;
};

/// Returns "union", "intersection", "difference" and "xor", in the order of the enumerators.
const std::vector<std::string>& boolean_operation_names();
/// Returns the operation of a name in boolean_operation_names().
BooleanOperation boolean_operation(std::string_view name);

/// Returns a problem for each operand that encloses nothing, and a problem if the result is empty
/// only because of rounding. `names` has the name of each operand, for messages.
std::vector<Problem> problems_of(const BooleanResult& result,
                                 const std::vector<std::string>& names);

/// Parses a script. Throws InputError, naming the line, unless every line that is not blank or a
/// comment has the form NAME = OPERATION OPERAND... and there is at least one such line.
std::vector<ScriptLine> parse_boolean_script(std::string_view text);

struct ScriptResult {
  Mesh mesh;
  std::vector<Problem> problems;  ///< problems of all results, as returned by problems_of()
  std::size_t pairs = 0;  ///< number of intersecting pairs of faces, summed over the operations
  /// Number of repair rounds after rounding, summed over the operations.
  std::size_t rounding_repairs = 0;
  /// Number of operations that changed only the faces near one operand, in place.
  std::size_t in_place = 0;
  /// Bound on the displacement of the surface by merged flat faces.
  double merge_displacement = 0;
};

/// Runs the lines. `read` returns the mesh in a file. Throws the errors of boolean(), with the line
/// number in the message.
ScriptResult run_boolean_script(const std::vector<ScriptLine>& lines,
                                const std::function<Mesh(const std::string& file)>& read,
                                const BooleanOptions& options, const Progress& progress);

}  // namespace transformesh
