/// A distance function sampled at many points, exactly where it is small and estimated elsewhere: a
/// far surface moves by its clamp whatever the distance, so most searches can be saved.
///
/// A distance changes by no more than the way gone. Points are visited along a Hilbert curve; one
/// whose distance is certainly beyond `exact_within`, and that lies within half of the last
/// searched distance from that search, gets the linear estimate. Its sign is certain where the
/// function is continuous, and it is typically right to a few percent, in the mean too.
/// Deterministic for any number of threads. Cost: O(n log n) and the searches.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

struct SearchedDistance {
  double distance = 0;           ///< with or without sign
  Vec3 gradient = Vec3::Zero();  ///< of unit length, or zero where distance is 0
};

/// One distance per point. `search` is called from several threads at once.
std::vector<double> sample_distance(
    std::span<const Vec3> points, double exact_within,
    const std::function<SearchedDistance(const Vec3& point)>& search);

/// The distance from `point` to its closest point, taken with the sign given.
SearchedDistance searched_distance(const Vec3& point, const Vec3& closest, double sign = 1);

}  // namespace transformesh
