/// Boolean operations on documents: their meshes are combined, their comments and further elements
/// united.
#pragma once

#include <string>
#include <vector>

#include "transformesh/boolean.h"
#include "transformesh/document.h"
#include "transformesh/errors.h"

namespace transformesh {

/// The commands: those of boolean_operation_names(), and cut, for the part of a sheet outside or
/// inside of a solid.
const std::vector<std::string>& boolean_commands();
const std::string& cut_command();

struct DocumentsBoolean {
  BooleanResult result;            ///< without the mesh
  std::vector<Problem> problems;   ///< problems_of() the result
  std::vector<std::string> notes;  ///< lines that append() returns
};

/// Makes the first document that of the result. `names` are those of the documents, for messages.
/// Positions are rounded to doubles as soon as one document has doubles. `side` is for cut.
DocumentsBoolean combine_documents(const std::string& command, SheetSide side,
                                   std::vector<Document>& documents,
                                   const std::vector<std::string>& names, BooleanOptions options,
                                   const Progress& progress);

/// Copies the comments on lengths of a document that was read, unless the other one has such a
/// unit: the unit, and the bound of how far flat faces moved. Returns whether the units agree.
bool unite_length_comments(Document& all, const Document& read);

}  // namespace transformesh
