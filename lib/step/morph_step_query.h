/// A step of a morph whose target is searched in step after step.
#pragma once

#include "step/target_query.h"
#include "transformesh/morph_step.h"

namespace transformesh {

/// Does what morph_step() of morph_step.h does. The query keeps its search structures.
MorphStepResult morph_step(Mesh& mesh, const TargetQuery& query,
                           const MorphStepOptions& options = {},
                           const Progress& progress = Progress());

}  // namespace transformesh
