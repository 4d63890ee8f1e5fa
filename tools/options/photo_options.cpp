#include "options/photo_options.h"

#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/hull.h"
#include "transformesh/length.h"
#include "views/cameras/view.h"
#include "views/cameras/view_files.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photo_steps.h"

namespace transformesh::tool {
namespace {

void declare_sources(Program& program, ViewSources& sources) {
  program.options.text("cameras", &sources.cameras, "WHERE", "file, folder or pattern of cameras")
      .is_needed = true;
  program.options.text("images", &sources.images, "WHERE", "the photographs").is_needed = true;
  program.options.text("silhouettes", &sources.silhouettes, "WHERE",
                       "masks, not black where the object is, that pull the surface");
}

void declare_comparison(Program& program, PhotoOptions& options) {
  PhotoconsistencyOptions& photographs = options.steps.step.photographs;
  program.options.number("scale", &options.scale, 1, 1e3,
                         "make photographs this many times smaller");
  program.options.integer("pairs", &options.pairs.neighbors, 1, 1000,
                          "neighbors with which each view is compared, at most");
  program.options.number("min-angle", &options.pairs.minimum_angle_deg, 0, 180,
                         "least angle between these, in degrees");
  program.options.number("max-angle", &options.pairs.maximum_angle_deg, 0, 180,
                         "largest such angle");
  program.options.flag("alternate", &options.steps.alternate,
                       "compare pairs in one order only, and in every other step in the other one");
  program.options.integer("window", &photographs.correlation.radius, 1, 5,
                          "radius of compared windows, in pixels");
  program.options.number("robust", &photographs.correlation.robust, 0, 1e3,
                         "disagreement at which a window pulls by a quarter; 0: all pull alike");
  program.options.named(
      "interpolation", &photographs.interpolation,
      {{"catmull-rom", Interpolation::catmull_rom}, {"bilinear", Interpolation::bilinear}},
      "of intensities between pixels");
}

void declare_step(Program& program, PhotoOptions& options) {
  PhotoStepOptions& step = options.steps.step;
  program.options.integer("iterations", &options.steps.iterations, 1, 1000, "steps in a row");
  program.options.number(
      "momentum", &options.steps.momentum, 0, 0.99,
      "share of a step's movement that goes on in the next one, but for the last");
  program.options.named(
      "step", &step.rule,
      {{"gauss-newton", PhotoStepRule::gauss_newton}, {"paper", PhotoStepRule::gradient}},
      "how far to go down the gradient");
  program.options.number("alpha", &step.alpha, 0, 1e300,
                         "clamp on the movement, as a fraction of the mean edge at the vertex");
  program.options.number("stiffness", &step.stiffness, 0, 1e300,
                         "gauss-newton: of the surface, where 1 is the usual pull of photographs");
  program.options.number("pull", &step.silhouettes, 0, 1e300, "the same of silhouettes");
  program.options.named("silhouettes-show", &step.meaning,
                        {{"exact", SilhouetteMeaning::exact}, {"least", SilhouetteMeaning::least}},
                        "the object, or only some of it: then they pull outwards alone");
  program.options.number("time-step", &step.time_step, 0, 1e300,
                         "paper: t, in units of length to the fourth power");
  program.options.number("smooth", &step.smoothing, 0, 1,
                         "paper: share of the way to the mean of the neighbors");
}

}  // namespace

void declare_photo_step(Program& program, PhotoOptions& options) {
  declare_sources(program, options.sources);
  declare_view_check(program, options.check, options.sources);
  declare_comparison(program, options);
  declare_step(program, options);
}

PhotoScene read_scene(const PhotoOptions& options, Run& run) {
  const PairOptions& pairs = options.pairs;
  if (!(pairs.minimum_angle_deg < pairs.maximum_angle_deg)) {
    throw UsageError("--min-angle " + shortest_text(pairs.minimum_angle_deg) +
                     " is not below --max-angle " + shortest_text(pairs.maximum_angle_deg) +
                     ": no angle lies between them");
  }
  ViewSources sources = options.sources;
  sources.on_note = [&run](const std::string& text) { run.note(text); };
  std::vector<View> views = views_from(sources);
  ViewCheck check;
  if (options.steps.step.meaning == SilhouetteMeaning::exact)
    check = check_views(views, options.check, run);
  run.report("dropped_views", check.dropped.size());
  run.report("least_agreement", check.least_agreement);
  return photo_scene(views, options.scale, pairs);
}

}  // namespace transformesh::tool
