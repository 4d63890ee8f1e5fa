#include "options/morph_options.h"

#include "frame/smoothing_option.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

void declare_movement(Program& program, MorphChoices& choices) {
  program.options.number(
      "alpha", &choices.options.step.displace.alpha, 0, 1e300,
      "largest movement of a vertex, as a fraction of the mean length of its edges");
  program.options.number("time-step", &choices.options.step.displace.time_step, 0, 1e300,
                         "fraction of the distance to the target by which vertices move in a step");
  program.options.named("distance", &choices.options.step.distance,
                        {{"auto", std::nullopt},
                         {"surface", MorphDistance::surface},
                         {"points", MorphDistance::points},
                         {"vertex", MorphDistance::vertex}},
                        "distance to the target's faces, or to the tangent planes at its nearest "
                        "vertices or vertex; auto: surface if it has faces, else points");
}

void declare_edges(Program& program, MorphChoices& choices) {
  program.options.text("smooth", &choices.smooth, "KIND", "smoothing, as --smooth of tm-remesh");
  program.options.length("min-edge", &choices.options.iteration.min_edge, "collapse shorter edges");
  program.options.length("max-edge", &choices.options.iteration.max_edge, "split longer edges");
  program.options.number("gap-edges", &choices.options.step.gap_edges, 0, 1e6,
                         "number of edges across gaps and walls of the target, so that edges are "
                         "short only there; 0: the same length everywhere");
  program.options.named(
      "features", &choices.options.features,
      {{"auto", Features::automatic}, {"on", Features::on}, {"off", Features::off}},
      "align the result with the target's sharp edges; auto: if the target has "
      "them, except in a sequence");
  program.reference_edge();
  program.options.integer(
      "scales", &choices.options.scales, 1, 10,
      "coarse to fine: begin with edges 2^(N-1) times as long, and halve them N-1 times");
}

// Quotes a file name for a shell. A name that begins with a dash must not become an option.
std::string file_word(const std::string& name) {
  return shell_word(name != "-" && name.starts_with('-') ? "./" + name : name);
}

std::string step_words(const MorphChoices& choices, const std::string& target, const Run& run) {
  const MorphStepOptions& step = choices.options.step;
  return "tm-morph-step --no-provenance --target " + target + " --distance " +
         run.program().options.find("distance")->text() + " --alpha " +
         shortest_text(step.displace.alpha) + " --time-step " +
         shortest_text(step.displace.time_step) + " --gap-edges " + shortest_text(step.gap_edges);
}

std::string remesh_words(const MorphChoices& choices) {
  const IterationOptions& iteration = choices.options.iteration;
  return "tm-remesh --no-provenance --smooth " + shell_word(choices.smooth) + " --min-edge " +
         iteration.min_edge.text() + " --max-edge " + iteration.max_edge.text() +
         (choices.options.step.gap_edges > 0 ? " --size-field size" : "") + " --feature-angle 180";
}

}  // namespace

void declare_morph(Program& program, MorphChoices& choices) {
  program.options.text("target", &choices.target, "FILE", "mesh or points to move towards");
  program.options.flag("sequence", &choices.sequence,
                       "morph to the meshes named after SOURCE, one after the other");
  declare_iterations(program, choices.loop);
  declare_movement(program, choices);
  declare_edges(program, choices);
  declare_record(program, choices.loop,
                 "number of iterations between frames (default 10; with --sequence every frame)",
                 "iteration, or per frame of a sequence");
  program.options.flag(
      "print-pipeline", &choices.print_pipeline,
      "print a shell loop over filters that makes the same meshes, and do nothing else");
}

void check_morph(const MorphChoices& choices, const Run& run) {
  const DisplaceOptions& movement = choices.options.step.displace;
  if (movement.alpha == 0 || movement.time_step == 0)
    throw UsageError("--alpha and --time-step must be above 0: otherwise no vertex moves");
  const std::vector<std::string>& inputs = run.in().names();
  if (choices.sequence) {
    if (!choices.target.empty()) throw UsageError("give either --target or --sequence, not both");
    if (inputs.size() < 2)
      throw UsageError("--sequence needs a source and at least one target mesh: SOURCE FRAME...");
    return;
  }
  if (choices.target.empty()) throw UsageError("the target is missing: give --target FILE");
  if (choices.target == "-")
    throw UsageError("--target: name a file: standard input is for the source");
  if (inputs.size() > 1)
    throw UsageError("at most one source can be given, but '" + inputs[1] + "' is a second one");
}

MorphOptions morphing_of(const MorphChoices& choices, Run& run) {
  MorphOptions options = choices.options;
  options.iteration.reference_edge = run.in().reference_edge();
  options.iteration.remesh = RemeshOptions();
  read_smoothing(choices.smooth, options.iteration.remesh);
  return options;
}

std::string pipeline_of(const MorphChoices& choices, const Run& run) {
  if (choices.options.scales > 1 || choices.sequence) {
    throw UsageError(
        "--print-pipeline needs a loop whose steps are known in advance: leave out --scales and "
        "--sequence");
  }
  const std::string output = run.out().name() == "-" ? "evolved.ply" : run.out().name();
  const std::string mesh = file_word(output);
  std::string target = file_word(choices.target);
  // Without --reference-edge, the script passes the length 1x, which is one reference edge, to
  // tm-clean. Then tm-clean measures the reference edge of the source and stores it in the mesh,
  // before vertices move.
  std::string edge = run.program().common.reference_edge;
  if (edge.empty()) edge = "1x";

  std::string text =
      "set -euo pipefail\ntm-clean --no-provenance --outermost --format ply --reference-edge " +
      edge + " -o " + mesh + ' ' + file_word(run.in().name()) + '\n';
  if (choices.options.step.gap_edges > 0) {
    // The script measures the local thickness of the target once and stores it in a file. The
    // measurement takes longer than an iteration.
    const std::string measured = file_word(output + ".target.ply");
    text += step_words(choices, target, run) + " --write-target " + measured + " -o /dev/null " +
            mesh + '\n';
    target = measured;
  }
  text += "for iteration in $(seq " + std::to_string(choices.loop.iterations) + "); do\n";
  text += "  " + step_words(choices, target, run) + ' ' + mesh + " |\n";
  text += "    tm-clean --no-provenance --outermost |\n";
  text += "    " + remesh_words(choices) + " -o " + mesh + "\ndone\n";
  return text + "tm-clean --no-provenance --outermost -o " + mesh + ' ' + mesh + '\n';
}

}  // namespace transformesh::tool
