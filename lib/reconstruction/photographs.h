/// Photographs of a reconstruction at one scale after the other, and steps towards them
/// (paper 5.3).
#pragma once

#include <optional>
#include <vector>

#include "reconstruction/carving.h"
#include "reconstruction/initial_state.h"
#include "reconstruction/start_comparison.h"
#include "transformesh/reconstruction_options.h"
#include "views/cameras/view.h"
#include "views/photo/disagreement.h"
#include "views/photo/photo_scene.h"
#include "views/photo/photo_steps.h"

namespace transformesh {

struct SweepForces {
  double loss = 0;                               ///< CorrelationOptions::robust
  double stiffness = 1;                          ///< factor of the stiffness in the options
  std::optional<int> iterations = std::nullopt;  ///< number of steps; default: that of the options
};

/// The photographs at the most recently requested scale, and steps towards them.
class Photographs {
 public:
  Photographs(std::vector<View>& views, int width, const ReconstructionOptions& options,
              const InitialState& initial_state);

  /// Takes the steps of a sweep.
  PhotoStepsResult sweep(Mesh& mesh, double scale, const SweepForces& forces,
                         const Progress& progress);
  /// Measures the surface by a step without movement. Compares pairs of views in one order or in
  /// both.
  PhotoStepResult look(Mesh mesh, double scale, bool in_one_order, const Progress& progress);
  /// Measures the surface at scale 1; without `doubt` in half of the time.
  SurfaceMeasures measures(const Mesh& mesh, bool with_doubt, const Progress& progress);
  /// Returns Disagreement::of_vertex of a surface at a scale. Keeps the views, and the scene of the
  /// last scale.
  std::vector<WindowSums> disagreement_at(const Mesh& mesh, double scale, const Progress& progress);
  /// Measures the surface at a scale, which the scene then has.
  CarvingEvidence carving_evidence(const Mesh& mesh, double scale, const Progress& progress);
  /// True if exact masks are known, so that the surface must fill them.
  bool has_exact_outlines() const { return steps_.step.meaning == SilhouetteMeaning::exact; }
  int width() const { return width_; }
  double pixel() const { return pixel_size(views_); }

 private:
  const PhotoScene& at(double scale);
  /// Returns SurfaceMeasures::outlines at a scale.
  std::vector<double> outlines(const Mesh& mesh, double scale);
  /// Returns the options with the window radius of the scale and the silhouette weight for its
  /// pairs.
  PhotoStepsOptions steps_at(double scale);

  std::vector<View>& views_;
  int width_;
  bool spends_views_;
  PairOptions pairs_;
  /// Pairs above scale 1, where the surface may be inaccurate. Views that are far apart would
  /// compare places that the true surface occludes.
  PairOptions near_pairs_;
  PhotoStepsOptions steps_;
  std::optional<double> pull_;
  bool are_outlines_;  ///< true if silhouettes are outlines of the hull
  WindowRadii windows_;
  double scale_ = 0;  ///< scale of `scene_`; 0: none
  PhotoScene scene_;
};

}  // namespace transformesh
