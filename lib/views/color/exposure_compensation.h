/// Evens out exposures: gains of photographs with which they show the same intensities where they
/// see the same places of a surface. Reference: the gain compensation of Brown & Lowe, "Automatic
/// panoramic image stitching using invariant features", IJCV 74(1), 2007, section 6; here for each
/// color by itself, so that white balances are evened out as well.
///
/// Minimized is the sum over all pairs of good glimpses of a place of (g1 a - g2 b)^2 / 100, with
/// the mean intensities a and b of their views where both see something, and of (1 - g)^2 for each
/// of them. Intensities that are nearly black or white, and those that differ by more than half, as
/// highlights do, say nothing.
#pragma once

#include <span>
#include <vector>

#include "views/color/best_view_colors.h"

namespace transformesh {

/// For each view, from 1/4 to 4; 1 where nothing is known. O(places), and sparse equations with as
/// many unknowns as there are views; deterministic.
std::vector<Gain> compensate_exposure(std::span<const BestViewColors> seen, std::size_t views);

/// The largest of all gains and of their inverses: 1 where exposures are the same.
double largest_gain(std::span<const Gain> gains);

}  // namespace transformesh
