/// Boolean operations on documents. A document is a mesh with the comments of its file, and with
/// the PLY elements other than vertices and faces. The result has the combined mesh, and the
/// comments and elements of all operands.
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
  BooleanResult result;           ///< result of the Boolean operation, without its mesh
  std::vector<Problem> problems;  ///< problems of operands and result, as returned by problems_of()
  /// One note for each column that is a list in one document and a number in another, from
  /// append().
  std::vector<std::string> notes;
};

/// Runs a command on the meshes and stores the result in documents[0]; the other documents lose
/// their meshes. `names` has the file name of each document, for messages. Positions are rounded
/// to doubles if a document has doubles, and to floats otherwise. Only cut_command() uses `side`.
DocumentsBoolean combine_documents(const std::string& command, SheetSide side,
                                   std::vector<Document>& documents,
                                   const std::vector<std::string>& names, BooleanOptions options,
                                   const Progress& progress);

/// Merges the comments about lengths of `read` into those of `all`. If `all` has no length unit, it
/// gets the unit of `read`. Of the bounds on the displacement by merged flat faces, the larger one
/// is kept.
void unite_length_comments(Document& all, const Document& read);

}  // namespace transformesh
