/// Exposure compensation: finds a factor (gain) for each photograph, so that intensities at points
/// of a surface agree after multiplication by the gains.
/// Reference: the gain compensation of Brown & Lowe, "Automatic panoramic image stitching using
/// invariant features", IJCV 74(1), 2007, section 6. Unlike in this reference, each color channel
/// has its own gain, so that white balances are compensated as well.
///
/// The gains minimize a sum over all surface points and all pairs of good views of a point
/// (BestViewColors). A pair contributes (g1 a - g2 b)^2 / 100. Here g1 and g2 are the gains of the
/// two views, and a and b their mean intensities over all their common points. A pair also
/// contributes (1 - g1)^2 + (1 - g2)^2. Nearly black or white intensities are ignored. Pairs whose
/// intensities have a ratio above 1.5, as at highlights, are ignored, too.
#pragma once

#include <span>
#include <vector>

#include "views/color/best_view_colors.h"

namespace transformesh {

/// Returns the gains of each view, from 1/4 to 4; 1 if a view has no common points with other
/// views. `seen` has the colors of each surface point. Takes O(points), and solves a sparse linear
/// system with one unknown per view. Deterministic.
std::vector<Gain> compensate_exposure(std::span<const BestViewColors> seen, std::size_t views);

/// Returns the largest of all gains and their inverses; 1 if all exposures are equal.
double largest_gain(std::span<const Gain> gains);

}  // namespace transformesh
