/// tm-boolean: union, intersection, difference and symmetric difference of solids, in one
/// arrangement (Zhou et al. 2016), and the part of a sheet outside or inside of a solid.
#include "boolean/boolean_script.h"
#include "entries/entries.h"
#include "frame/run.h"
#include "io/comments.h"
#include "options/clean_notes.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

struct Choices {
  std::string script;
  bool inside = false, no_merge_flat = false, require_nonempty = false;
  BooleanOptions options;
};

CleanResult combine(const std::vector<Operand>& operands, const Choices& choices, tool::Run& run) {
  const std::string& command = run.program().word;
  if (command != "cut")
    return boolean(boolean_operation(command), operands, choices.options, run.progress());
  if (operands.size() != 2) throw UsageError("cut needs two meshes: a sheet and a solid");
  const SheetSide side = choices.inside ? SheetSide::inside : SheetSide::outside;
  return cut_sheet(operands[0], operands[1], side, choices.options, run.progress());
}

/// The first document with the comments and elements of all, and with another mesh.
void replace_mesh(std::vector<Document>& documents, Mesh mesh, tool::Run& run) {
  for (Document& document : documents) {
    document.mesh.positions.clear();
    document.mesh.faces.clear();
    document.mesh.vertex_columns = document.mesh.vertex_columns.select({});
    document.mesh.face_columns = document.mesh.face_columns.select({});
  }
  for (std::size_t i = 1; i < documents.size(); ++i)
    for (const std::string& line : append(documents[0], documents[i])) run.note(line);
  documents[0].mesh = std::move(mesh);
}

void combine_inputs(Choices& choices, tool::Run& run) {
  std::vector<Document>& documents = run.in().documents();
  std::vector<Operand> operands;
  choices.options.coordinate = Scalar::float32;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    operands.push_back({&documents[i].mesh, run.in().names()[i]});
    if (documents[i].style.coordinate == Scalar::float64)
      choices.options.coordinate = Scalar::float64;
  }
  CleanResult result = combine(operands, choices, run);
  tool::note_cleaning(result, run);
  replace_mesh(documents, std::move(result.mesh), run);
  add_planarity(documents[0].style.comments, result.merge_displacement);
  run.report("operands", operands.size());
  run.report(entries_of(result));
}

void run_script(const Choices& choices, tool::Run& run) {
  const std::vector<ScriptLine> lines = parse_boolean_script(run.in().read_bytes(choices.script));
  bool is_first = true;
  const auto read = [&](const std::string& file) {
    Document document = run.in().read(file);
    Mesh mesh = std::move(document.mesh);
    document.mesh = {};
    if (std::exchange(is_first, false)) run.continue_from(std::move(document));
    return mesh;
  };
  ScriptResult result = run_boolean_script(lines, read, choices.options, run.progress());
  run.document().mesh = std::move(result.mesh);
  add_planarity(run.document().style.comments, result.merge_displacement);
  run.report({{"operations", lines.size()},
              {"pairs", result.pairs},
              {"rounding_repairs", result.rounding_repairs},
              {"merge_displacement", result.merge_displacement}});
}

void make_result(Choices& choices, tool::Run& run) {
  choices.options.merge_flat = !choices.no_merge_flat;
  choices.script.empty() ? combine_inputs(choices, run) : run_script(choices, run);
  if (!run.document().mesh.faces.empty()) return;
  if (choices.require_nonempty) throw GoalError("the result is empty");
  run.note("the result is empty: a mesh without faces");
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-boolean",
                        "[OPTION]... COMMAND MESH... | --script FILE",
                        "Combines solids: union, intersection, difference or xor",
                        {tool::Reads::meshes, tool::Soups::own}};
  program.output.is_clean = true;
  program.input.is_absent = [&] { return !choices.script.empty(); };
  program.words = {"COMMAND", "union, intersection, difference, xor, or cut SHEET SOLID"};
  program.words.choices = boolean_operation_names();
  program.words.choices.emplace_back("cut");
  program.options.text("script", &choices.script, "FILE",
                       "run a file of operations: NAME = COMMAND OPERAND... in each line");
  program.options.flag("inside", &choices.inside, "of cut: the part inside the solid");
  program.options.flag("source-operand", &choices.options.source_operand,
                       "write the operand of each face as the face property source_operand");
  program.options.flag("no-merge-flat", &choices.no_merge_flat,
                       "leave the faces of flat regions as they were cut");
  program.options.flag("require-nonempty", &choices.require_nonempty,
                       "exit 4 if the result is empty");
  program.epilog =
      "Cut a ball out of a box:\n  tm-shape box > a.ply; tm-shape sphere > b.ply\n"
      "  tm-boolean difference a.ply b.ply > c.ply";
  return program.run(argc, argv, [&](tool::Run& run) { make_result(choices, run); });
}
