/// One step of a morph (paper 5.2 with the step of 5.1.1): velocities towards the target, then
/// displace(). Distances far from the target, where every movement is clamped, are estimated to a
/// few percent; movements are the same as with exact ones. Guarantees and cost: morph.h,
/// displace.h.
#pragma once

#include <optional>
#include <string>

#include "step/displace.h"
#include "step/morph.h"

namespace transformesh {

struct MorphStepOptions {
  /// By default to the surface where the target has faces.
  std::optional<MorphDistance> distance;
  DisplaceOptions displace;
  std::string mask;  ///< vertex column by which velocities are multiplied; empty: none
  /// > 0, where the target's thickness is measured: the vertex column `size` becomes the edge
  /// length that puts so many edges across narrow places.
  double gap_edges = 0;
  double largest_size = 0;  ///< input units; sizes are between a twentieth of it and all of it
  /// Whose vertices the mesh has to reach, for `from_target`; null: all of the target's.
  const Target* goal = nullptr;
};

/// Distances are those before the movement.
struct MorphStepResult {
  MorphDistance distance = MorphDistance::surface;  ///< the one taken
  DistanceSummary to_target;
  DistanceSummary from_target;
  DisplaceResult displaced;
};

MorphStepResult morph_step(Mesh& mesh, const TargetQuery& query,
                           const MorphStepOptions& options = {},
                           const Progress& progress = Progress());

}  // namespace transformesh
