/// Variant of morph_step() for many steps with one target.
#pragma once

#include "step/target_query.h"
#include "transformesh/morph_step.h"

namespace transformesh {

/// Does the same as morph_step() (morph_step.h), and reuses the search structures of `query`.
MorphStepResult morph_step(Mesh& mesh, const TargetQuery& query,
                           const MorphStepOptions& options = {},
                           const Progress& progress = Progress());

}  // namespace transformesh
