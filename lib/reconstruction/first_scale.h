/// Chooses the scale of photographs at which the refinement of a given start begins.
///
/// Coarse scales find large errors, but blur what is accurate and tear thin parts. Steps find their
/// way where windows of the photographs are more alike than different. So the finest scale at which
/// this holds on nearly the whole start is enough. Photographs at coarser scales disagree even on
/// the true surface, because windows reach across contours.
#pragma once

#include <functional>
#include <vector>

#include "views/photo/disagreement.h"

namespace transformesh {

/// Returns one of the scales, which fall and end with 1. `disagreement_at` measures the start
/// (Disagreement::of_vertex). Returns the finest scale at which at most 3 % of the compared windows
/// belong to vertices with a dissimilarity above 0.5. If there is none, returns the coarsest scale
/// at which this share is within 5 % of the least one. Returns the coarsest scale if nothing is
/// compared.
double first_scale(const std::vector<double>& scales,
                   const std::function<std::vector<WindowSums>(double scale)>& disagreement_at);

}  // namespace transformesh
