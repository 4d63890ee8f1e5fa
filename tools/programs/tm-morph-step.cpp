/// tm-morph-step: one step of a surface towards a target (section 5.2 of the TransforMesh paper).
#include "frame/column_notes.h"
#include "frame/displacement_report.h"
#include "frame/run.h"
#include "io/document/unit.h"
#include "io/streams/streams.h"
#include "mesh/touching_borders.h"
#include "step/local_thickness.h"
#include "step/morph_check.h"
#include "step/morph_step_query.h"
#include "step/target_file.h"
#include "transformesh/morph_step.h"

namespace {

using namespace transformesh;

struct Options {
  std::string target;
  std::string written_target;
  MorphStepOptions step;
};

const char* name_of(MorphDistance distance) {
  if (distance == MorphDistance::surface) return "surface";
  return distance == MorphDistance::points ? "points" : "vertex";
}

Target target_of(const Options& options, tool::Run& run) {
  run.progress()("read target");
  Target target = read_target(run.in().read_bytes(options.target), input_name(options.target),
                              run.in().reading(options.target));
  run.say().note_all(target.notes);
  run.in().note_unit(find_unit(target.unit));
  if (target.has_estimated_normals) {
    run.note("the target's points have no normals: estimated from their neighbors");
  }
  // A target file of --write-target was checked when it was written.
  if (!target.is_prepared)
    run.say().note_all(check_target(target, input_name(options.target), run.progress()));
  if (options.step.gap_edges > 0 && target.thickness.empty())
    target =
        with_thickness(target, options.step.gap_edges, run.in().reference_edge(), run.progress());
  if (!options.written_target.empty())
    run.out().write(options.written_target, write_target(target));
  return target;
}

void step(Document& document, Options options, tool::Run& run) {
  refuse_touching_borders(document.mesh);
  if (options.step.gap_edges > 0) options.step.largest_size = run.in().reference_edge();
  const Target target = target_of(options, run);
  run.say().note_all(check_source(document.mesh, target, input_name(run.in().name())));
  const MorphStepResult result = morph_step(document.mesh, target, options.step, run.progress());
  run.report("distance", name_of(result.distance));
  run.report(entries_of(result));
  tool::note_new_normals(result.displaced.new_normals, run);
  note_clamped(result.displaced, options.step.displace.alpha,
               "far from the target this is intended; use more steps to reach it", run);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  DisplaceOptions& displace = options.step.displace;
  tool::Program program{"tm-morph-step", "[OPTION]... --target FILE [INPUT]",
                        "Moves a mesh one step towards a target"};
  program.options.text("target", &options.target, "FILE", "mesh or points to move towards")
      .is_needed = true;
  program.options.named("distance", &options.step.distance,
                        {{"auto", std::nullopt},
                         {"surface", MorphDistance::surface},
                         {"points", MorphDistance::points},
                         {"vertex", MorphDistance::vertex}},
                        "distance to the target's faces, or to the tangent planes at its nearest "
                        "vertices or vertex; auto: surface if it has faces, else points");
  program.options.number("time-step", &displace.time_step, 0, 1e300,
                         "fraction of the distance to the target by which vertices move in a step");
  program.options.number(
      "alpha", &displace.alpha, 0, 1e300,
      "largest movement of a vertex, as a fraction of the mean length of its edges");
  program.options.text("mask", &options.step.mask, "COLUMN",
                       "multiply velocities by this vertex property; 0 fixes a vertex");
  program.options.number("gap-edges", &options.step.gap_edges, 0, 1e6,
                         "write the vertex property size for tm-remesh --size-field: edges with "
                         "this number across gaps and walls of the target; 0: do not");
  program.options
      .output_file("write-target", &options.written_target,
                   "write the prepared target, with estimated normals, for later steps")
      .endings = {".ply"};
  program.example =
      "tm-morph-step --target target.ply source.ply | tm-clean | tm-remesh > next.ply";
  return program.run(argc, argv, [&](tool::Run& run) { step(run.document(), options, run); });
}
