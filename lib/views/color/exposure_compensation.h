/// Exposure compensation. Multiplied by their gains, photographs agree on the intensities at points
/// of a surface.
/// Reference: the gain compensation of Brown & Lowe, "Automatic panoramic image stitching using
/// invariant features", IJCV 74(1), 2007, section 6. Unlike in this reference, each color channel
/// has its own gain, so that white balances are compensated as well.
///
/// The gains minimize a sum over all pairs of good views of a surface point (BestViewColors). A
/// pair contributes (g1 a - g2 b)^2 / 100, where a and b are the mean intensities of the two views
/// over all their common points. A pair also contributes (1 - g)^2 for both gains g. Nearly black
/// or white intensities are ignored. Pairs whose intensities differ by more than half, such as
/// highlights, are ignored, too.
#pragma once

#include <span>
#include <vector>

#include "views/color/best_view_colors.h"

namespace transformesh {

/// Returns the gains of each view, from 1/4 to 4; 1 if a view overlaps no other view. O(places),
/// and a sparse linear system with one unknown per view. Deterministic.
std::vector<Gain> compensate_exposure(std::span<const BestViewColors> seen, std::size_t views);

/// Returns the largest of all gains and their inverses; 1 if all exposures are equal.
double largest_gain(std::span<const Gain> gains);

}  // namespace transformesh
