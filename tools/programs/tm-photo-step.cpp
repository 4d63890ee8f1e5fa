/// tm-photo-step: moves a surface towards agreement with calibrated photographs (section 5.3 of the
/// TransforMesh paper).
#include "frame/column_notes.h"
#include "frame/displacement_report.h"
#include "mesh/touching_borders.h"
#include "options/photo_options.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photo_steps.h"

namespace {

using namespace transformesh;

void report(const PhotoScene& scene, const PhotoStepsResult& result, tool::Run& run) {
  run.report("views", scene.views.size());
  run.report("pairs", scene.pairs.size());
  run.report("pixel_size", scene.pixel);
  run.report("energy", result.first.energy);
  run.report("dissimilarity", result.first.dissimilarity);
  run.report("last_dissimilarity", result.last.dissimilarity);
  run.report("pixels", result.first.pixels);
  run.report("last_pixels", result.last.pixels);
  run.report("coverage", result.first.coverage);
  run.report("last_coverage", result.last.coverage);
  run.report("lost_coverage", result.lost_coverage);
  run.report("unseen", result.last.unseen);
  run.report("outside", result.last.outside);
  run.report("mean_share", result.last.mean_share);
  tool::note_new_normals(result.last.displaced.new_normals, run);
  run.report(entries_of(result.last.displaced));
  if (result.lost_coverage)
    run.note("photographs can be compared on less of the surface than before");
}

void step(Document& document, const tool::PhotoOptions& options, tool::Run& run) {
  refuse_touching_borders(document.mesh);
  run.progress()("read views");
  const PhotoScene scene = tool::read_scene(options, run);
  const PhotoStepsOptions& steps = options.steps;
  const PhotoStepsResult result = photo_steps(document.mesh, scene, steps, run.progress());
  report(scene, result, run);
  const bool has_time_step = steps.step.rule == PhotoStepRule::gradient;
  tool::note_clamped(result.last.displaced, steps.step.alpha,
                     has_time_step ? "use a smaller --time-step, or a larger --alpha"
                                   : "use more steps, or a larger --alpha",
                     run);
}

}  // namespace

int main(int argc, char** argv) {
  tool::PhotoOptions options;
  tool::Program program{"tm-photo-step", "[OPTION]... --cameras WHERE --images WHERE [INPUT]",
                        "Moves a mesh towards agreement with calibrated photographs"};
  tool::declare_photo_step(program, options);
  program.epilog =
      "One iteration of a reconstruction, at a coarse scale:\n"
      "  tm-photo-step --cameras par.txt --images photos --scale 4 < a.ply |\n"
      "    tm-clean | tm-remesh > next.ply";
  program.example = "tm-photo-step --cameras par.txt --images photos --scale 4 hull.ply > next.ply";
  return program.run(argc, argv, [&](tool::Run& run) { step(run.document(), options, run); });
}
