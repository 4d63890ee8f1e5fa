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
  program.options
      .text("cameras", &sources.cameras, "WHERE", "file, folder or pattern of the cameras")
      .is_needed = true;
  program.options
      .text("images", &sources.images, "WHERE", "file, folder or pattern of the photographs")
      .is_needed = true;
  program.options.text("silhouettes", &sources.silhouettes, "WHERE",
                       "masks that pull the surface; pixels that are not black show the object");
}

void declare_comparison(Program& program, PhotoOptions& options) {
  PhotoconsistencyOptions& photographs = options.steps.step.photographs;
  program.options.number("scale", &options.scale, 1, 1e3,
                         "factor by which photographs are reduced");
  program.options.integer("pairs", &options.pairs.neighbors, 1, 1000,
                          "maximum number of neighbors with which each view is compared");
  program.options.number("min-angle", &options.pairs.minimum_angle_deg, 0, 180,
                         "smallest angle between compared views, in degrees");
  program.options.number("max-angle", &options.pairs.maximum_angle_deg, 0, 180,
                         "largest angle between compared views, in degrees");
  program.options.flag(
      "alternate", &options.steps.alternate,
      "compare each pair in one order only, and alternate the order from step to step");
  program.options.integer("window", &photographs.correlation.radius, 1, 5,
                          "radius of the compared windows, 1 to 5 pixels");
  program.options.number("robust", &photographs.correlation.robust, 0, 1e3,
                         "disagreement at which a window has a quarter of its usual weight; 0: all "
                         "windows have the same weight");
  program.options.named(
      "interpolation", &photographs.interpolation,
      {{"catmull-rom", Interpolation::catmull_rom}, {"bilinear", Interpolation::bilinear}},
      "interpolation of intensities between pixels");
}

void declare_step(Program& program, PhotoOptions& options) {
  PhotoStepOptions& step = options.steps.step;
  program.options.integer("iterations", &options.steps.iterations, 1, 1000,
                          "number of consecutive steps");
  program.options.number(
      "momentum", &options.steps.momentum, 0, 0.99,
      "fraction of the previous movement that is added to each step except the last");
  program.options.named(
      "step", &step.rule,
      {{"gauss-newton", PhotoStepRule::gauss_newton}, {"paper", PhotoStepRule::gradient}},
      "rule for the length of a step; paper: that of Zaharescu et al. 2011");
  program.options.number(
      "alpha", &step.alpha, 0, 1e300,
      "largest movement of a vertex, as a fraction of the mean length of its edges");
  program.options.number(
      "stiffness", &step.stiffness, 0, 1e300,
      "gauss-newton: resistance to bending, where 1 is the usual pull of photographs");
  program.options.number("pull", &step.silhouettes, 0, 1e300,
                         "weight of the silhouettes, where 1 is the usual weight of photographs");
  program.options.named(
      "silhouettes-show", &step.meaning,
      {{"exact", SilhouetteMeaning::exact}, {"least", SilhouetteMeaning::least}},
      "masks show the whole object, or only a part of it: then they only pull outwards");
  program.options.number("time-step", &step.time_step, 0, 1e300,
                         "paper: step size t, in units of length to the fourth power");
  program.options.number(
      "smooth", &step.smoothing, 0, 1,
      "paper: fraction of the way to the mean of its neighbors that a vertex moves");
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
