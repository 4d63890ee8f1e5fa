/// Chooses the scale of photographs at which the refinement of a given start begins.
///
/// Coarse scales find large errors, but blur what is accurate, and tear thin parts. So the choice
/// depends on the faces where photographs at full scale disagree. Photographs at a scale whose
/// pixels are larger than an error hardly see it. Hence these faces agree best at the scale that is
/// as coarse as their error.
#pragma once

#include <functional>
#include <vector>

#include "views/photo/disagreement.h"

namespace transformesh {

/// Returns one of the scales, which fall and end with 1. `disagreement_at` measures the start
/// (Disagreement::of_vertex). Returns 1 if photographs disagree by more than 0.3 beyond their noise
/// on at most 8 % of the start. Otherwise returns the coarsest scale at which the disagreement of
/// these vertices is within 5 % of the least one.
double first_scale(const std::vector<double>& scales,
                   const std::function<std::vector<WindowSums>(double scale)>& disagreement_at);

}  // namespace transformesh
