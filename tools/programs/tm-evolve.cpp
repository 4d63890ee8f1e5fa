/// tm-evolve: the evolution of paper 5.1 around any filter that moves vertices.
#include <cstdlib>

#include "evolution/filter_step.h"
#include "evolution/loop/iteration_text.h"
#include "evolution/loop/record.h"
#include "evolution/recorded_loops.h"
#include "frame/filter_process.h"
#include "frame/loop_options.h"
#include "frame/smoothing_option.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/evolve.h"

namespace {

using namespace transformesh;

struct Options {
  std::string step;
  std::string until;
  DisplaceOptions displace;
  std::string smooth = "0.1";
  IterationOptions iteration;
  tool::LoopChoices loop;
};

void declare(tool::Program& program, Options& options) {
  program.options
      .text("step", &options.step, "COMMAND",
            "filter that moves vertices: a mesh in and a mesh out, or the vertex properties vx "
            "vy vz out; TM_ITERATION holds the number of the iteration")
      .is_needed = true;
  program.input.soups = tool::Soups::own;
  tool::declare_iterations(program, options.loop);
  program.options.text("until", &options.until, "moved:LENGTH|stalled|components:N|genus:N",
                       "stop when no vertex moves as far, nothing gets better any more, or the "
                       "mesh has that many components or handles");
  program.options.number(
      "alpha", &options.displace.alpha, 0, 1e300,
      "clamp on the movement by vx vy vz, as a fraction of the mean edge at the vertex");
  program.options.number("time-step", &options.displace.time_step, -1e300, 1e300,
                         "movement by vx vy vz is so many times as far");
  program.options.text("smooth", &options.smooth, "KIND", "smoothing of tm-remesh");
  program.options.length("min-edge", &options.iteration.min_edge, "collapse shorter edges");
  program.options.length("max-edge", &options.iteration.max_edge, "split longer edges");
  program.reference_edge();
  tool::declare_record(program, options.loop, "every how many iterations (default 10)",
                       "iteration");
}

UntilRule until_of(const std::string& text, tool::Run& run) {
  constexpr std::string_view moved = "moved:";
  if (text.empty()) return {};
  if (text == "stalled") return stalled();
  if (text.starts_with(moved))
    return moved_less_than(run.length(parse_length(text.substr(moved.size()))));
  UntilRule rule;
  if (text.starts_with("components:")) rule.components = number_in<long>(text.substr(11));
  if (text.starts_with("genus:")) rule.genus = number_in<long>(text.substr(6));
  if (rule.components || rule.genus) return rule;
  throw UsageError("--until: '" + text +
                   "' is none of moved:LENGTH, stalled, components:N and genus:N");
}

Step step_of(const Options& options, const Record& record, Scalar coordinate) {
  const auto filter = [&](const std::string& bytes) {
    setenv("TM_ITERATION", std::to_string(record.iteration() + 1).c_str(), 1);
    return tool::run_filter(options.step, bytes);
  };
  return step_through(filter, coordinate, options.displace);
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

void evolve_mesh(Options& options, tool::Run& run) {
  Record record = tool::open_record(options.loop, 10, run);
  Document& document = tool::begin_document(record, run);
  tool::begin_run(options.loop, record, &document, run);
  EvolveOptions evolution{options.iteration, until_of(options.until, run)};
  evolution.iteration.reference_edge = run.in().reference_edge();
  evolution.iteration.remesh = RemeshOptions();
  tool::read_smoothing(options.smooth, evolution.iteration.remesh);
  const Step step = step_of(options, record, document.style.coordinate);
  EvolveResult result;
  tool::evolve_or_keep(run, record, "iteration", [&] {
    result =
        evolve(document, step, evolution, tool::loop_of(options.loop, run), record, run.progress());
  });
  run.report(entries_of(result));
  note_clamped(result, options.displace.alpha, run);
  tool::conclude(run, options.loop, record,
                 {result.is_done, result.is_done, summary(result, document.mesh)});
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-evolve",
                        "[OPTION]... --step COMMAND [SOURCE] -o OUT",
                        "Evolves a mesh by a filter that moves its vertices",
                        {tool::Reads::file},
                        {tool::Writes::evolved_mesh}};
  declare(program, options);
  program.example =
      "tm-evolve --step 'tm-displace --normal-speed 0.01' mesh.ply --iterations 5 -o next.ply";
  return program.run(argc, argv, [&](tool::Run& run) { evolve_mesh(options, run); });
}
