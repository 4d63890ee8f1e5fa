#include "reconstruction/photographs.h"

#include "reconstruction/initial_mesh.h"
#include "reconstruction/outline_agreements.h"
#include "reconstruction/sweep_rules.h"
#include "support/number.h"

namespace transformesh {
namespace {

/// PairOptions::spread at scales above 1. Only views that are close together are then compared.
constexpr double near_spread = 1.5;

}  // namespace

Photographs::Photographs(std::vector<View>& views, int width, const ReconstructionOptions& options,
                         const InitialState& initial_state)
    : views_(views),
      width_(width),
      spends_views_(options.spends_views),
      pairs_(options.pairs),
      near_pairs_(options.pairs),
      steps_{.step = options.step},
      pull_(options.pull),
      are_outlines_(initial_state.outlined.has_value()),
      windows_(options.windows) {
  near_pairs_.spread = near_spread;
  steps_.iterations = options.iterations.value_or(initial_state.coarsest ? 8 : 5);
  steps_.momentum = options.momentum;
  steps_.step.meaning = are_outlines_ ? SilhouetteMeaning::least : options.initial.meaning;
}

const PhotoScene& Photographs::at(double scale) {
  if (scale == scale_) return scene_;
  scene_ = PhotoScene();
  // Scale 1 is the last scale. The views at full size are not needed afterwards.
  const bool is_last = spends_views_ && scale == 1;
  const PairOptions& pairs = scale > 1 ? near_pairs_ : pairs_;
  scene_ = is_last ? take_photo_scene(views_, scale, pairs) : photo_scene(views_, scale, pairs);
  scale_ = scale;
  return scene_;
}

PhotoStepsOptions Photographs::steps_at(double scale) {
  PhotoStepsOptions options = steps_;
  const double pull = pull_.value_or(is_wide(at(scale).pairs) ? 1.5 : 0.5);
  options.step.silhouettes = are_outlines_ ? read_back(significant(0.2 * pull, 9)) : pull;
  options.step.photographs.correlation.radius = windows_.at(scale);
  return options;
}

PhotoStepsResult Photographs::sweep(Mesh& mesh, double scale, const SweepForces& forces,
                                    const Progress& progress) {
  PhotoStepsOptions options = steps_at(scale);
  options.alternate = true;
  options.iterations = forces.iterations.value_or(options.iterations);
  options.step.photographs.correlation.robust = forces.loss;
  options.step.stiffness *= forces.stiffness;
  return photo_steps(mesh, at(scale), options, progress);
}

PhotoStepResult Photographs::look(Mesh mesh, double scale, bool in_one_order,
                                  const Progress& progress) {
  PhotoStepsOptions options = steps_at(scale);
  options.iterations = 1;
  options.alternate = in_one_order;
  options.step.alpha = 0;
  return photo_steps(mesh, at(scale), options, progress).first;
}

SurfaceMeasures Photographs::measures(const Mesh& mesh, bool with_doubt, const Progress& progress) {
  SurfaceMeasures result{look(mesh, 1, false, progress), {}, outlines(mesh, 1)};
  if (with_doubt)
    result.doubt = surface_doubt(mesh, at(1), steps_.step.least_cosine,
                                 steps_at(1).step.photographs, progress);
  return result;
}

std::vector<WindowSums> Photographs::disagreement_at(const Mesh& mesh, double scale,
                                                     const Progress& progress) {
  PhotoconsistencyOptions options = steps_.step.photographs;
  options.correlation.radius = windows_.at(scale);
  const PhotoScene scene = photo_scene(views_, scale, scale > 1 ? near_pairs_ : pairs_);
  return disagreement(mesh, scene, steps_.step.least_cosine, options, progress).of_vertex;
}

CarvingEvidence Photographs::carving_evidence(const Mesh& mesh, double scale,
                                              const Progress& progress) {
  const PhotoScene& scene = at(scale);
  const PhotoconsistencyOptions options = steps_at(scale).step.photographs;
  return {disagreement(mesh, scene, steps_.step.least_cosine, options, progress).of_vertex,
          SurfaceMeasures{{}, {}, outlines(mesh, scale)}.mean_outline()};
}

std::vector<double> Photographs::outlines(const Mesh& mesh, double scale) {
  if (!has_exact_outlines()) return {};
  return outline_agreements(mesh, at(scale));
}

}  // namespace transformesh
