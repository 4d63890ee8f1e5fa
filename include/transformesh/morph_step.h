/// One step of a morph (paper 5.2 with the step of 5.1.1): every vertex p moves by -phi(p) along
/// its normal, where phi is a signed distance to the target. Movements are clamped as in
/// displace(). The part of a surface outside of the target shrinks, the part inside grows.
/// Reference: Breen & Whitaker, "A level-set approach for the metamorphosis of solid models", TVCG
/// 2001. A component of the target that the source does not overlap is not reached. A component of
/// the source outside of the target shrinks. Distances so large that movements are clamped have
/// errors of a few percent, without effect on movements. Cost: O(n log m). Deterministic for any
/// number of threads.
#pragma once

#include <optional>
#include <string>

#include "transformesh/control.h"
#include "transformesh/displace.h"
#include "transformesh/target.h"

namespace transformesh {

/// Definition of the signed distance phi(p).
enum class MorphDistance {
  surface,  ///< distance to the closest point of the target's faces
  /// ((q - p) . n) for the nearest vertex q and its normal n, as in the paper. Needs a target that
  /// is sampled as finely as the source. Vanishes near sharp edges.
  vertex,
  /// Like `vertex`, but twelve planes decide the side of far points (Kolluri, "Provably good moving
  /// least squares", TALG 4(2), 2008).
  points
};

struct MorphStepOptions {
  std::optional<MorphDistance> distance;  ///< default: `surface` for a mesh, else `points`
  DisplaceOptions displace;
  std::string mask;  ///< vertex column that multiplies the velocities; empty: none
  /// Wanted number of edges across narrow places. If it is > 0 and the target's thickness is
  /// measured, the vertex column `size` is set to an edge length.
  double gap_edges = 0;
  double largest_size = 0;  ///< largest value of `size`; input units; the smallest is 1/20 of this
  /// Only this part of the target is measured for `from_target`; null: the whole target.
  const Target* goal = nullptr;
};

struct DistanceSummary {
  double rms = 0, maximum = 0;
};

struct MorphStepResult {
  MorphDistance distance = MorphDistance::surface;  ///< definition that was used
  DistanceSummary to_target;    ///< distances of the mesh vertices before the movement; input units
  DistanceSummary from_target;  ///< distances of at most 1024 target vertices; input units
  DisplaceResult displaced;
};

/// Moves the vertices. Throws as displace() does, InputError for a mesh without faces, and
/// UsageError if `surface` is set for a target of points.
MorphStepResult morph_step(Mesh& mesh, const Target& target, const MorphStepOptions& options = {},
                           const Progress& progress = Progress());

}  // namespace transformesh
