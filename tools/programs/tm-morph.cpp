/// tm-morph: evolves a mesh until it coincides with a target, or follows a movie of targets
/// (section 5.2 of the TransforMesh paper).
#include "evolution/loop/record.h"
#include "evolution/loop/run_folder.h"
#include "evolution/recorded_loops.h"
#include "io/document/unit.h"
#include "io/streams/streams.h"
#include "options/morph_options.h"
#include "options/morph_report.h"
#include "step/morph_check.h"
#include "step/target_file.h"
#include "transformesh/morph.h"

namespace {

using namespace transformesh;

constexpr const char* state_target = "target.ply";

void check_start(const Mesh& source, const Target& target, tool::Run& run) {
  run.say().note_all(check_source(source, target, input_name(run.in().name())));
}

Target read(const std::string& name, tool::Run& run) {
  Target target = read_target(run.in().read_bytes(name), input_name(name), run.in().reading(name));
  run.say().note_all(target.notes);
  run.in().note_unit(find_unit(target.unit));
  if (target.has_estimated_normals)
    run.note("the target's points have no normals: estimated from their neighbors");
  run.say().note_all(check_target(target, input_name(name), run.progress()));
  return target;
}

// Returns the target from the state of the run that is continued. If no run is continued, reads the
// file of --target.
Target target_of(const tool::MorphChoices& choices, Record& record, tool::Run& run) {
  if (const auto kept = record.find(state_target)) return read_target(*kept, state_target);
  Target target = read(choices.target, run);
  check_start(run.document().mesh, target, run);
  record.add(state_target, write_target(target));
  return target;
}

void morph_to_target(const tool::MorphChoices& choices, Record& record, tool::Run& run) {
  Document& document = tool::begin_document(record, run);
  const MorphOptions options = tool::morphing_of(choices, run);
  const Target target = target_of(choices, record, run);
  tool::begin_run(choices.loop, record, &document, run, {{run_file::target, write_target(target)}});
  MorphResult result;
  tool::evolve_or_keep(run, record, "iteration", [&] {
    result =
        morph(document, target, options, tool::loop_of(choices.loop, run), record, run.progress());
  });
  tool::report_morph(result, run);
  tool::conclude(run, choices.loop, record,
                 {result.stop != MorphStop::iteration_limit, result.stop == MorphStop::converged,
                  tool::summary(result, document.mesh, run.program())});
}

void follow_sequence(const tool::MorphChoices& choices, Record& record, tool::Run& run) {
  Document& document = tool::begin_document(record, run);
  const std::vector<std::string> names(run.in().names().begin() + 1, run.in().names().end());
  const MorphOptions options = tool::morphing_of(choices, run);
  tool::begin_run(choices.loop, record, &document, run);
  const auto target_of = [&](std::size_t frame) {
    Target target = read(names[frame], run);
    if (const std::string& folder = choices.loop.run; !folder.empty())
      add_to_run(folder, {{run_name(run_file::targets, frame + 1, ".ply"), write_target(target)}});
    return target;
  };
  TrackResult result;
  tool::evolve_or_keep(run, record, "frame", [&] {
    result = track(document, names, target_of, options, tool::loop_of(choices.loop, run), record,
                   run.progress());
  });
  tool::report_tracking(result, document.mesh, run);
  tool::conclude(run, choices.loop, record,
                 {true, result.converged == result.frames, tool::summary(result, document.mesh)});
}

void evolve(const tool::MorphChoices& choices, tool::Run& run) {
  tool::check_morph(choices, run);
  if (choices.print_pipeline) {
    run.out().write_nothing();
    return run.out().write("-", tool::pipeline_of(choices, run));
  }
  Record record = tool::open_record(choices.loop, choices.sequence ? 1 : 10, run);
  choices.sequence ? follow_sequence(choices, record, run) : morph_to_target(choices, record, run);
}

}  // namespace

int main(int argc, char** argv) {
  tool::MorphChoices choices;
  tool::Program program{"tm-morph",
                        "[OPTION]... [SOURCE] --target FILE [-o OUT]",
                        "Evolves a mesh until it lies on a target",
                        {tool::Reads::files},
                        {tool::Writes::evolved_mesh}};
  program.input.soups = tool::Soups::own;
  tool::declare_morph(program, choices);
  program.output.is_mesh = [&choices] { return !choices.print_pipeline; };
  program.example = "tm-morph source.ply --target target.ply --iterations 5 -o next.ply";
  return program.run(argc, argv, [&](tool::Run& run) { evolve(choices, run); });
}
