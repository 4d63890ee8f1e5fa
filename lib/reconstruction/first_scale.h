/// Chooses the scale of photographs at which the refinement of a given initial mesh (the start)
/// begins.
///
/// A scale is the factor by which photographs are reduced. Coarse scales correct large errors, but
/// blur accurate parts and tear thin parts. Steps of the surface converge where windows of the
/// photographs are more alike than different. The finest scale at which this holds on nearly the
/// whole start is therefore enough. Photographs at coarser scales disagree even on the true
/// surface, because windows reach across contours.
#pragma once

#include <functional>
#include <vector>

#include "views/photo/disagreement.h"

namespace transformesh {

/// Returns one of `scales`, which are in descending order and end with 1. `disagreement_at` returns
/// Disagreement::of_vertex of the start. Returns the finest scale at which at most 3 % of the
/// compared windows belong to vertices with a dissimilarity above 0.5. If there is no such scale,
/// returns the coarsest scale at which this share is at most 1.05 times the least share. Returns
/// the coarsest scale if no windows are compared.
double first_scale(const std::vector<double>& scales,
                   const std::function<std::vector<WindowSums>(double scale)>& disagreement_at);

}  // namespace transformesh
