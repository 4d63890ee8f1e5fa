/// From calibrated photographs to a closed surface without self-intersection (paper 5.3): from the
/// visual hull, opened where photographs see into it, or a mesh given, towards agreement of the
/// photographs, from coarse to fine. A sweep is remesh(), photo_steps(), clean(). Its topology is
/// what the photographs show: what the hull joins comes apart.
///
/// A coarse scale sees large errors, but its edges are long: where the first one fails or tears
/// thin parts off, and was not asked for, the loop begins anew with the next finer one. Where the
/// surface explodes (is_exploded) at scale 2 or above it begins anew four times as stiff, twice at
/// most; else it ends by a GoalError. At last, at rest, windows that disagree pull less.
///
/// The result is converged where it has no fault (reconstruction/convergence.h); the vertex column
/// `doubt` says where photographs disagree (surface_doubt.h). Deterministic for any number of
/// threads; the record of a run that was ended in any way continues to the same bytes.
/// Throws what the stages throw, a failure of a sweep with its number; the document is then that of
/// the last good one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evolution/loop/image_scales.h"
#include "evolution/loop/iteration.h"
#include "evolution/loop/loop.h"
#include "evolution/reconstruction/convergence.h"
#include "evolution/reconstruction/initial_mesh.h"
#include "evolution/reconstruction/sweep_rules.h"
#include "views/photo/photo_steps.h"

namespace transformesh {

struct ReconstructionOptions {
  InitialMeshOptions initial;
  ScaleOptions scales;
  PairOptions pairs;
  WindowRadii windows;
  std::optional<int> iterations =
      std::nullopt;        ///< of a sweep. Nothing: 5, but 8 from an opened hull
  std::size_t sweeps = 4;  ///< at a scale, at most; twice while the topology changes
  /// Of masks; outlines of the hull, which are as if only the least was shown, pull by a fifth of
  /// it. Nothing: 0.5, or 1.5 where photographs say little as they are far apart (is_wide).
  std::optional<double> pull = std::nullopt;
  double momentum = 0.7;    ///< of the steps
  PhotoStepsOptions steps;  ///< but for what is said above and in `initial`
  /// The views may be cropped to the object, where they are packed (PackableImage), and lose their
  /// images in the end: for less memory, where they are not needed any more.
  bool spends_views = false;
  double robust = 1;  ///< the factor of robust_loss, for the last sweeps
  /// [0, 1]: at last, components of less than this share of the largest one's volume go.
  double crumbs = 0.001;
  /// At late scales handles go that a loop of so many of the last edges goes around (handles.h):
  /// meshes of such edges hold none, and what looks like one is a web between near parts. 0: all
  /// stay.
  double handles = 5;
  std::function<void(const std::string& message)> on_sweep = {};
  std::function<void(const std::string& message)> on_note = {};  ///< of what went wrong
  std::function<void(const std::string& message)> on_detail = {};
};

struct ReconstructionResult {
  std::size_t sweeps = 0;  ///< earlier runs included
  std::string fault;       ///< why it is not converged; empty where it is
  Topology topology;
  std::size_t crumbs = 0;   ///< components that went at last
  std::size_t handles = 0;  ///< that went on the way and at last
  double pixel = 0;         ///< length of a pixel's side where the cameras look
  std::size_t faces = 0;
  PhotoStepResult first,
      last;  ///< of the initial mesh and of the result, at full scale; nothing moved
  SurfaceEvidence evidence;
};

/// `views` have photographs and, where there are masks, silhouettes; else they get some, but for
/// InitialMeshOptions. Of a document without a mesh given the comments count. In the record's
/// folder `start.ply` and `hull.ply` are kept as well.
ReconstructionResult reconstruct(Document& document, std::vector<View>& views,
                                 const ReconstructionOptions& options, Record& record,
                                 const Progress& progress = Progress());

/// For the log: "2 sweeps: 812 faces, components 1, genus 0; ...".
std::string summary_of(const ReconstructionResult& result);

}  // namespace transformesh
