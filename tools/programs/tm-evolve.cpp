/// tm-evolve: moves the vertices of a mesh by any motion, and remeshes and cleans the mesh after
/// each step (section 5.1 of the TransforMesh paper).
#include <cstdint>
#include <cstdlib>

#include "evolution/filter_step.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/record.h"
#include "evolution/recorded_loops.h"
#include "frame/filter_process.h"
#include "frame/loop_options.h"
#include "options/evolve_options.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/evolve.h"

namespace {

using namespace transformesh;

Step step_of(const tool::EvolveChoices& choices, const Record& record, Scalar coordinate) {
  const auto filter = [&](const std::string& bytes) {
    setenv("TM_ITERATION", std::to_string(record.iteration() + 1).c_str(), 1);
    return tool::run_filter(choices.step, bytes);
  };
  DisplaceOptions displace = choices.displace;
  displace.time_step = time_factor(choices.time);
  return step_through(filter, coordinate, displace);
}

void note_clamped(const EvolveResult& result, double alpha, tool::Run& run) {
  if (result.clamped_iterations == 0) return;
  run.note(clamps_in_words(result, alpha) +
           "; use a smaller --time-step and more --iterations, or a larger --alpha");
}

std::string summary(const EvolveResult& result, const Mesh& mesh) {
  return (result.is_done ? "converged after " : "iteration limit reached after ") +
         counted(result.iterations, "iteration") + ": " +
         in_short(mesh.faces.size(), result.last.topology);
}

EvolveResult evolve_by_steps(const tool::EvolveChoices& choices, Document& document, Record& record,
                             tool::Run& run) {
  const EvolveOptions options = evolution_of(choices, run);
  const Step step = step_of(choices, record, document.style.coordinate);
  EvolveResult result =
      evolve(document, step, options, tool::loop_of(choices.loop, run), record, run.progress());
  run.report(entries_of(result));
  note_clamped(result, choices.displace.alpha, run);
  return result;
}

EvolveResult evolve_by_time(const tool::EvolveChoices& choices, Document& document, Record& record,
                            tool::Run& run) {
  const EvolveOptions options = evolution_of(choices, run);
  const Flow flow = motion_of(choices.time, [&] { return record.iteration() + 1; });
  check_integrator(flow, choices.time, run.program());
  LoopOptions loop = tool::loop_of(choices.loop, run);
  if (!run.program().options.find("iterations")->is_given) loop.iterations = SIZE_MAX;
  const TimeResult result =
      evolve_in_time(document, flow.motion, time_options_of(choices.time, run), options, loop,
                     record, run.progress());
  run.report(entries_of(result));
  note_time(result, choices.time, run);
  if (flow.counts) note_flow(flow, run);
  return result.evolution;
}

void evolve_mesh(tool::EvolveChoices& choices, tool::Run& run) {
  check_evolve(choices, run.program());
  Record record = tool::open_record(choices.loop, 10, run);
  Document& document = tool::begin_document(record, run);
  tool::begin_run(choices.loop, record, &document, run);
  EvolveResult result;
  tool::evolve_or_keep(run, record, "iteration", [&] {
    result = choices.is_in_time() ? evolve_by_time(choices, document, record, run)
                                  : evolve_by_steps(choices, document, record, run);
  });
  tool::conclude(run, choices.loop, record,
                 {result.is_done, result.is_done, summary(result, document.mesh)});
}

}  // namespace

int main(int argc, char** argv) {
  tool::EvolveChoices choices;
  tool::Program program{"tm-evolve",
                        "[OPTION]... --step COMMAND|--time NUMBER [SOURCE] [-o OUT]",
                        "Evolves a mesh by any motion of its vertices",
                        {tool::Reads::file, tool::Soups::own},
                        {tool::Writes::evolved_mesh}};
  declare_evolve(program, choices);
  program.example =
      "tm-evolve --step 'tm-displace --normal-speed 0.01' mesh.ply --iterations 5 -o next.ply";
  return program.run(argc, argv, [&](tool::Run& run) { evolve_mesh(choices, run); });
}
