/// Boolean operations on documents, which are meshes with the comments and further elements of
/// their files. The result has the combined mesh, and the comments and elements of all operands.
#pragma once

#include <string>
#include <vector>

#include "transformesh/boolean.h"
#include "transformesh/document.h"
#include "transformesh/errors.h"

namespace transformesh {

/// Names of all commands: those of boolean_operation_names(), and cut_command().
const std::vector<std::string>& boolean_commands();
/// Name of the command that calls cut_sheet().
const std::string& cut_command();

struct DocumentsBoolean {
  BooleanResult result;            ///< result of the operation, without its mesh
  std::vector<Problem> problems;   ///< problems that problems_of() returns for the result
  std::vector<std::string> notes;  ///< lines that append() returns
};

/// Runs a command on the meshes and stores the result in documents[0]; the other documents lose
/// their meshes. `names` has the file name of each document, for messages. Positions are rounded
/// to doubles if a document has doubles, and to floats otherwise. Only cut_command() uses `side`.
DocumentsBoolean combine_documents(const std::string& command, SheetSide side,
                                   std::vector<Document>& documents,
                                   const std::vector<std::string>& names, BooleanOptions options,
                                   const Progress& progress);

/// Copies the length unit of `read` to `all` if `all` has no unit, and keeps the larger bound on
/// the displacement by merged flat faces. Returns false if both documents have units and these
/// differ.
bool unite_length_comments(Document& all, const Document& read);

}  // namespace transformesh
