/// Options of reconstruct() (reconstruct.h).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "transformesh/photo_step.h"

namespace transformesh {

/// Options of the initial mesh.
struct InitialMeshOptions {
  bool is_given = false;      ///< start from the mesh in the document, not from the visual hull
  std::string name = {};      ///< name of the given mesh in messages
  bool clips_by_hull = true;  ///< intersect the given mesh with the hull of exact silhouettes
  SilhouetteMeaning meaning = SilhouetteMeaning::exact;
  /// Threshold for views without silhouettes. Default: Otsu's; no silhouettes if a mesh is given.
  std::optional<ThresholdOptions> threshold = std::nullopt;
  std::optional<double> keep = std::nullopt;  ///< HullOptions::keep; default: depends on the masks
  bool opens_hollows = true;                  ///< carve concavities of the hull by depth maps
  double least_agreement =
      0.7;  ///< least overlap of thresholded silhouettes with their hull; [0, 1]
};

/// Scales: factors by which photographs are reduced.
struct ScaleOptions {
  std::optional<double> coarsest = std::nullopt;  ///< first factor >= 1; default: image width / 28
  double edge = 3;                                ///< edge in pixels of the reduced images; >= 1
  double last_edge = 3;                           ///< last edge in pixels of the full images; >= 1
  double largest = 11.3;                          ///< upper limit of the default of `coarsest`
};

/// Radii of compared windows in pixels, 1 to 5.
struct WindowRadii {
  int coarse = 3, fine = 3;
  /// Returns `coarse` at scales of 2 and above, else `fine`.
  int at(double scale) const;
};

struct ReconstructionOptions {
  InitialMeshOptions initial;
  ScaleOptions scales;
  PairOptions pairs;
  WindowRadii windows;
  std::optional<int> iterations = std::nullopt;  ///< steps per sweep; 5, or 8 if hollows are carved
  std::size_t sweeps = 4;                        ///< limit of sweeps at a scale; see scale_rule.h
  std::optional<double> pull = std::nullopt;  ///< silhouette weight; default 0.5, distant views 1.5
  double momentum = 0.7;      ///< fraction of the last movement that a step adds; [0, 1)
  PhotoStepOptions step;      ///< only its `stiffness`, `damping`, `alpha` are used
  bool spends_views = false;  ///< crop and finally clear the views, to save memory
  double robust = 1;      ///< CorrelationOptions::robust of the last sweeps over the mean 1 - cc
  double crumbs = 0.001;  ///< drop components below this fraction of the largest volume; [0, 1]
  double handles = 5;     ///< longest loop around a removed handle, in final edges; 0: remove none
  std::function<void(const std::string& message)> on_sweep = {};   ///< called after each sweep
  std::function<void(const std::string& message)> on_note = {};    ///< called with problems
  std::function<void(const std::string& message)> on_detail = {};  ///< called with details
};

}  // namespace transformesh
