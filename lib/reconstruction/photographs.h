/// Photographs of a reconstruction, reduced to one scale at a time, and steps of the surface
/// towards agreement of the photographs (paper 5.3).
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
  double loss = 0;       ///< CorrelationOptions::robust; 0: no robust loss
  double stiffness = 1;  ///< factor by which the stiffness of the options is multiplied
  /// Number of steps; default: the number in the options.
  std::optional<int> iterations = std::nullopt;
};

/// Keeps the reduced photographs of the scale that was requested last, and moves or measures
/// surfaces by them.
class Photographs {
 public:
  Photographs(std::vector<View>& views, int width, const ReconstructionOptions& options,
              const InitialState& initial_state);

  /// Moves the surface by the steps of one sweep.
  PhotoStepsResult sweep(Mesh& mesh, double scale, const SweepForces& forces,
                         const Progress& progress);
  /// Measures the surface: computes a step, but does not move the surface. If `in_one_order`, each
  /// pair of views is compared in one order only, else in both.
  PhotoStepResult look(Mesh mesh, double scale, bool in_one_order, const Progress& progress);
  /// Measures the surface at scale 1. Leaves SurfaceMeasures::doubt empty if `with_doubt` is false,
  /// which halves the time.
  SurfaceMeasures measures(const Mesh& mesh, bool with_doubt, const Progress& progress);
  /// Returns Disagreement::of_vertex of a surface at a scale. Does not change the stored scale, and
  /// does not clear the views.
  std::vector<WindowSums> disagreement_at(const Mesh& mesh, double scale, const Progress& progress);
  /// Measures the surface at a scale. The photographs of this scale are then the stored ones.
  CarvingEvidence carving_evidence(const Mesh& mesh, double scale, const Progress& progress);
  /// True if masks are exact, so that the outlines of the surface must equal them.
  bool has_exact_outlines() const { return steps_.step.meaning == SilhouetteMeaning::exact; }
  int width() const { return width_; }
  double pixel() const { return pixel_size(views_); }

 private:
  /// Returns the photographs at a scale; computes them unless it is the stored scale.
  const PhotoScene& at(double scale);
  /// Returns the overlaps of the surface's outlines and exact masks (SurfaceMeasures::outlines) at
  /// a scale.
  std::vector<double> outlines(const Mesh& mesh, double scale);
  /// Returns the options of steps, with the window radius for the scale and the weight of
  /// silhouettes for the pairs of views at the scale.
  PhotoStepsOptions steps_at(double scale);

  std::vector<View>& views_;
  int width_;
  bool spends_views_;
  PairOptions pairs_;
  /// Options of pairs above scale 1, at which the surface may be inaccurate. Pairs of views that
  /// are far apart would compare places that the true surface occludes.
  PairOptions near_pairs_;
  PhotoStepsOptions steps_;
  std::optional<double> pull_;
  bool are_outlines_;  ///< true if silhouettes are outlines of a visual hull, not masks
  WindowRadii windows_;
  double scale_ = 0;  ///< scale of `scene_`; 0: none
  PhotoScene scene_;
};

}  // namespace transformesh
