/// tm-repair: makes a solid from any mesh.
#include "frame/run.h"
#include "io/formats/file_format.h"
#include "options/repair_picture.h"
#include "options/repair_pipeline.h"
#include "transformesh/repair.h"

namespace {

using namespace transformesh;

struct Choices {
  RepairOptions options;
  std::optional<Length> max_change;
  std::string picture;
  bool dry_run = false;
  bool print_pipeline = false;
  bool passes_bytes = false;  ///< true if the output equals the input, byte for byte

  bool writes_mesh() const { return !dry_run && !print_pipeline && !passes_bytes; }
};

/// True if the output would have the triangles and the format of the input.
bool is_unchanged(const RepairResult& result, const Document& document, const tool::Run& run) {
  const tool::CommonValues& common = run.program().common;
  const bool has_indices =
      document.style.format != Format::stl_ascii && document.style.format != Format::stl_binary;
  return result.same_triangles && (result.steps.empty() || !has_indices) &&
         !run.in().bytes().empty() && run.in().format() == document.style.format &&
         !common.as_float && !common.as_double;
}

/// Sets the format and the type of coordinates if no mesh is written (--dry-run, --print-pipeline).
/// Coordinates are rounded as they would be on standard output.
void set_style_of_stdout(Document& document, const tool::Run& run) {
  const tool::CommonValues& common = run.program().common;
  std::optional<Scalar> coordinate;
  if (common.as_float || common.as_double)
    coordinate = common.as_float ? Scalar::float32 : Scalar::float64;
  set_format(document, format_for(run.in().format(), common.format, "-"), coordinate);
}

void repair_document(Document& document, Choices& choices, tool::Run& run) {
  if (!choices.writes_mesh()) set_style_of_stdout(document, run);
  if (choices.max_change) choices.options.max_change = run.length(*choices.max_change);
  choices.options.coordinate = document.style.coordinate;
  RepairResult result = repair(document.mesh, choices.options, run.progress());
  if (!choices.picture.empty())
    tool::write_repair_picture(document.mesh, result, choices.picture, run);
  choices.passes_bytes = is_unchanged(result, document, run);
  if (choices.passes_bytes) result.steps.clear();
  tool::note_steps(result, run);
  run.report(entries_of(result));
  const std::string commands = tool::pipeline_of(result, choices.passes_bytes, run);
  run.report("pipeline", commands);
  document.mesh = std::move(result.mesh);
  if (choices.print_pipeline) {
    run.out().set_bytes(commands + '\n');
  } else if (choices.dry_run) {
    run.out().write_nothing();
  } else if (choices.passes_bytes) {
    run.out().set_bytes(run.in().bytes());
  }
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-repair", "[OPTION]... [INPUT]",
                        "Makes a solid from any mesh with few changes, and reports them"};
  program.output.is_clean = true;
  program.input.soups = tool::Soups::own;
  program.input.keeps_bytes = true;
  program.options.flag("keep-open", &choices.options.keep_open,
                       "leave holes open; all other steps are the same");
  program.options.length(
      "max-change", &choices.max_change,
      "exit with 4 if the result is farther from the input than this (default: no limit)");
  program.options
      .flag("dry-run", &choices.dry_run, "report the steps that would be done, and write no mesh")
      .affects_result = false;
  program.options
      .flag("print-pipeline", &choices.print_pipeline,
            "print a pipeline of filters with the same effect, instead of the mesh")
      .affects_result = false;
  tool::declare_repair_picture(program, choices.picture);
  program.example = "tm-repair model.stl > solid.ply";
  program.output.is_mesh = [&] { return choices.writes_mesh(); };
  return program.run(argc, argv,
                     [&](tool::Run& run) { repair_document(run.document(), choices, run); });
}
