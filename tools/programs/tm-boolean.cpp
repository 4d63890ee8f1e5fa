/// tm-boolean: union, intersection, difference and symmetric difference of solids, and the part of
/// a sheet outside or inside of a solid.
#include "boolean/boolean_documents.h"
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

void combine_inputs(const Choices& choices, tool::Run& run) {
  const DocumentsBoolean combined =
      combine_documents(run.program().word, choices.inside ? SheetSide::inside : SheetSide::outside,
                        run.in().documents(), run.in().names(), choices.options, run.progress());
  for (const Problem& problem : combined.problems) run.say().note(problem);
  for (const std::string& line : combined.notes) run.note(line);
  tool::note_cleaning(combined.result, run);
  run.report("operands", run.in().names().size());
  run.report(entries_of(combined.result));
}

void run_script(const Choices& choices, tool::Run& run) {
  const std::vector<ScriptLine> lines = parse_boolean_script(run.in().read_bytes(choices.script));
  const auto read = [&](const std::string& file) {
    Document document = run.in().read(file);
    unite_length_comments(run.document(), document);
    return std::move(document.mesh);
  };
  ScriptResult result = run_boolean_script(lines, read, choices.options, run.progress());
  for (const Problem& problem : result.problems) run.say().note(problem);
  run.document().mesh = std::move(result.mesh);
  add_planarity(run.document().style.comments, result.merge_displacement);
  run.report({{"operations", lines.size()},
              {"in_place", result.in_place},
              {"pairs", result.pairs},
              {"rounding_repairs", result.rounding_repairs},
              {"merge_displacement", result.merge_displacement}});
}

void combine(Choices& choices, tool::Run& run) {
  if ((choices.inside || choices.options.cap) && run.program().word != cut_command())
    throw UsageError(std::string(choices.inside ? "--inside" : "--cap") +
                     " can be used only with cut");
  choices.options.merge_flat = !choices.no_merge_flat;
  if (run.program().common.as_float) choices.options.coordinate = Scalar::float32;
  choices.script.empty() ? combine_inputs(choices, run) : run_script(choices, run);
  const bool is_empty = run.document().mesh.faces.empty();
  if (is_empty && choices.require_nonempty) throw GoalError("the result is empty");
  if (is_empty) run.note("the result is empty: a mesh without faces");
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-boolean",
                        "[OPTION]... COMMAND MESH... | --script FILE",
                        "Combines solids: union, intersection, difference or xor",
                        {tool::Reads::meshes, tool::Soups::own},
                        {tool::Writes::mesh, true}};
  program.input.is_absent = [&] { return !choices.script.empty(); };
  program.words = {"COMMAND", "union, intersection, difference, xor, or cut SHEET SOLID"};
  program.words.choices = boolean_commands();
  program.options.text("script", &choices.script, "FILE",
                       "run the operations in this file, one per line: NAME = COMMAND OPERAND...");
  program.options.flag("inside", &choices.inside,
                       "for cut: keep the part of the sheet inside the solid");
  program.options.flag("cap", &choices.options.cap,
                       "for cut: close the kept part with faces of the solid");
  program.options.flag(
      "source-operand", &choices.options.source_operand,
      "write the number of each face's operand as the face property source_operand");
  program.options.flag("no-merge-flat", &choices.no_merge_flat,
                       "do not retriangulate flat regions in which faces were cut");
  program.options.flag("require-nonempty", &choices.require_nonempty,
                       "exit with 4 if the result is empty");
  program.example = "tm-boolean difference a.ply b.ply > cut.ply";
  return program.run(argc, argv, [&](tool::Run& run) { combine(choices, run); });
}
