#include "boolean/boolean_documents.h"

#include <algorithm>
#include <utility>

#include "boolean/boolean_script.h"
#include "io/comments.h"
#include "io/document/missing_colors.h"
#include "io/document/unit.h"
#include "io/streams/streams.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

BooleanResult combine(const std::string& command, SheetSide side,
                      const std::vector<Operand>& operands, const BooleanOptions& options,
                      const Progress& progress) {
  if (command != cut_command())
    return boolean(boolean_operation(command), operands, options, progress);
  if (operands.size() != 2) throw UsageError("cut needs two meshes: a sheet and a solid");
  return cut_sheet(operands[0], operands[1], side, options, progress);
}

void clear_rows(Mesh& mesh) {
  mesh.positions.clear();
  mesh.faces.clear();
  mesh.vertex_columns = mesh.vertex_columns.select({});
  mesh.face_columns = mesh.face_columns.select({});
}

}  // namespace

const std::vector<std::string>& boolean_commands() {
  static const std::vector<std::string> commands = [] {
    std::vector<std::string> all = boolean_operation_names();
    all.push_back(cut_command());
    return all;
  }();
  return commands;
}

const std::string& cut_command() {
  static const std::string command = "cut";
  return command;
}

DocumentsBoolean combine_documents(const std::string& command, SheetSide side,
                                   std::vector<Document>& documents,
                                   const std::vector<std::string>& names, BooleanOptions options,
                                   const Progress& progress) {
  std::vector<Operand> operands;
  std::vector<std::string> said_names;
  options.coordinate = Scalar::float32;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    said_names.push_back(input_name(names[i]));
    operands.push_back({&documents[i].mesh, said_names.back()});
    if (documents[i].style.coordinate == Scalar::float64) options.coordinate = Scalar::float64;
  }
  DocumentsBoolean combined{combine(command, side, operands, options, progress), {}, {}};
  combined.problems = problems_of(combined.result, said_names);
  for (std::size_t i = 1; i < documents.size(); ++i)
    for (std::string& line : notes_of_missing_colors(documents[0].mesh, documents[i].mesh))
      combined.notes.push_back(std::move(line));
  for (Document& document : documents) clear_rows(document.mesh);
  for (std::size_t i = 1; i < documents.size(); ++i)
    for (std::string& line : append(documents[0], documents[i]))
      combined.notes.push_back(std::move(line));
  documents[0].mesh = std::exchange(combined.result.mesh, {});
  add_planarity(documents[0].style.comments, combined.result.merge_displacement);
  return combined;
}

void unite_length_comments(Document& all, const Document& read) {
  std::vector<std::string>& comments = all.style.comments;
  const double moved = std::max(planarity_of(comments), planarity_of(read.style.comments));
  add_planarity(comments, moved - planarity_of(comments));
  const Unit* const unit = unit_of(read);
  if (unit_of(all) == nullptr && unit != nullptr) set_unit(all, *unit);
}

}  // namespace transformesh
