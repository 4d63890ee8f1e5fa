/// A distance function sampled at many points, exactly where it is small and estimated elsewhere: a
/// far surface moves by its clamp whatever the distance, so most searches can be saved.
///
/// A distance changes by no more than the way gone. Points are visited along a Hilbert curve. One
/// whose distance is certainly beyond `exact_within` gets the linear estimate from the last search,
/// if it lies within two fifths of the distance found there; else it is searched too, but not to
/// the end: its sign is that of the last one, and its distance at most 5 % too large. Estimates are
/// typically right to a few percent, in the mean too; signs are certain where the function is
/// continuous. Deterministic for any number of threads. Cost: O(n log n) and the searches.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct SearchedDistance {
  double distance = 0;           ///< with or without sign
  Vec3 gradient = Vec3::Zero();  ///< of unit length, or zero where distance is 0
  Index face = no_index;         ///< where it was found, as a hint for the next search
};

/// How far a search may go wrong where the sign is known.
inline constexpr double far_tolerance = 0.05;

/// One distance per point, given their hilbert_order(). `search` takes the index of a point and is
/// called from several threads at once; where `sign` is not 0 it is the sign of the distance, which
/// may come out too large by far_tolerance. `hint` is the face of a search nearby, or no_index.
std::vector<double> sample_distance(
    std::span<const Vec3> points, std::span<const Index> order, double exact_within,
    const std::function<SearchedDistance(Index point, double sign, Index hint)>& search);

/// The distance from `point` to its closest point, taken with the sign given.
SearchedDistance searched_distance(const Vec3& point, const Vec3& closest, double sign = 1);

}  // namespace transformesh
