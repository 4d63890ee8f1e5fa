/// tm-reconstruct: reconstructs a closed, clean mesh from calibrated photographs (section 5.3 of
/// the TransforMesh paper), or a mesh per time step of a movie.
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/record.h"
#include "frame/memory.h"
#include "options/reconstruct_options.h"
#include "reconstruction/reconstruction_entries.h"
#include "reconstruction/recorded_reconstruction.h"
#include "reconstruction/run_views.h"
#include "support/counted.h"
#include "support/error_prefix.h"
#include "transformesh/errors.h"
#include "views/cameras/view.h"

namespace {

using namespace transformesh;

// Returns the mesh of --start with the comments of the result. Without --start, returns an empty
// mesh with these comments.
Document initial_state(const std::string& start, tool::Run& run) {
  Document document;
  if (!start.empty()) document = run.in().read(start);
  run.out().stamp(document);
  return document;
}

void reconstruct_one(const tool::ReconstructChoices& choices, ReconstructionOptions options,
                     tool::Run& run) {
  Record record = tool::open_record(choices.loop, 1, run);
  Document& document = run.document();
  if (record.resumed()) {
    run.continue_from(record.resumed()->document);
  } else {
    document = initial_state(choices.options.initial.name, run);
  }
  run.progress()("read views");
  std::vector<View> views = tool::checked_views(choices.sources, choices, run);
  tool::begin_run(choices.loop, record, options.initial.is_given ? &document : nullptr, run,
                  choices.loop.run.empty() ? RunFiles() : run_files_of(views));
  options.spends_views = true;
  options.on_sweep = [&run](const std::string& text) { run.say().progress_line(text); };
  ReconstructionResult result;
  tool::evolve_or_keep(run, record, "sweep", [&] {
    result = reconstruct(document, views, options, record, run.progress());
  });
  run.report("views", views.size());
  run.report(entries_of(result));
  std::set<std::string> names;
  for (const View& view : views) names.insert(view.name);
  views.clear();
  tool::color_result(choices, names, run);
  tool::conclude(run, choices.loop, record, {true, result.fault.empty(), summary_of(result)});
}

std::vector<TimeStep> time_steps_of(const std::string& sequence) {
  try {
    return time_steps(sequence);
  } catch (const Error&) {
    rethrow_with_prefix("--sequence ");
  }
}

std::string summary_of(const SequenceResult& result) {
  return counted(result.time_steps, "time step") + ", " + std::to_string(result.tracked) +
         " tracked, " + std::to_string(result.accepted) + " accepted";
}

void reconstruct_movie(const tool::ReconstructChoices& choices,
                       const ReconstructionOptions& reconstruction, tool::Run& run) {
  SequenceOptions options = tool::sequence_of(choices, reconstruction, run);
  const std::vector<TimeStep> steps = time_steps_of(choices.sequence);
  Record record = tool::open_record(choices.loop, 1, run, options.states);
  const std::string& folder = choices.loop.run;
  if (folder.empty()) run.out().write_nothing();

  options.comments = initial_state("", run).style.comments;
  Document& document = run.document();
  if (!record.resumed()) document = initial_state(choices.options.initial.name, run);
  tool::begin_run(choices.loop, record, reconstruction.initial.is_given ? &document : nullptr, run);
  const auto views_of = [&](const TimeStep& step) {
    std::vector<View> views =
        tool::checked_views(tool::sources_of(choices.sources, step), choices, run);
    const std::size_t number = &step - steps.data() + 1;
    if (!folder.empty()) add_to_run(folder, run_files_of(views, number));
    return views;
  };
  const SequenceResult result =
      reconstruct_sequence(document, steps, views_of, options, record, run.progress());
  run.report(entries_of(result));
  tool::conclude(run, choices.loop, record,
                 {true, result.accepted == result.time_steps, summary_of(result)});
}

}  // namespace

int main(int argc, char** argv) {
  tool::ReconstructChoices choices;
  tool::Program program{"tm-reconstruct",
                        "[OPTION]... --cameras WHERE --images WHERE [-o OUT]",
                        "Reconstructs a surface from calibrated photographs",
                        {tool::Reads::nothing},
                        {tool::Writes::evolved_mesh}};
  program.input.soups = tool::Soups::own;
  tool::declare_reconstruction(program, choices);
  program.example =
      "tm-reconstruct --cameras par.txt --images photos --silhouettes masks -o object.ply";
  return program.run(argc, argv, [&](tool::Run& run) {
    tool::give_large_blocks_back();
    const ReconstructionOptions options = tool::reconstruction_of(choices, run);
    choices.sequence.empty() ? reconstruct_one(choices, options, run)
                             : reconstruct_movie(choices, options, run);
  });
}
