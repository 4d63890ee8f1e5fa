/// Samples a signed distance function at many points. Small distances are exact, large distances
/// are estimates. This is enough for morphing, which limits the movement of vertices that are far
/// from the target. Estimates save most of the searches for closest points.
///
/// Points are visited along a Hilbert curve. A distance function has Lipschitz constant 1, so that
/// the last search bounds the distance of the next point. If this distance certainly exceeds
/// `exact_within`, there are two cases. If the point is closer to the point of the last search than
/// two fifths of the found distance, its distance is extrapolated linearly. Otherwise a new search
/// finds a distance that is at most 5 % too large, and the sign of the last search is kept.
/// Estimates are typically right to a few percent, also on average. Signs are right if the function
/// is continuous. Deterministic for any number of threads. Cost: O(n log n) plus the searches.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

struct SearchedDistance {
  double distance = 0;           ///< value of the distance function
  Vec3 gradient = Vec3::Zero();  ///< unit vector, or zero if the distance is 0
  Index face = no_index;         ///< closest face, as a hint for the next search
};

/// Largest relative error of a search whose exact distance is not needed. A larger value makes such
/// searches faster, but more points then need an exact search.
inline constexpr double far_tolerance = 0.05;

/// Returns the signed distance of each point. `order` must be the result of hilbert_order() for the
/// points, or a part of it in the same order; the distance of all other points is 0. `search`
/// receives the index of a point and is called from several threads. If its argument `sign` is 0,
/// `search` must return the exact distance. Otherwise `sign` is the sign of the distance to return,
/// and this distance may be too large by the fraction far_tolerance. `hint` is the closest face of
/// a nearby point, or no_index.
std::vector<double> sample_distance(
    std::span<const Vec3> points, std::span<const Index> order, double exact_within,
    const std::function<SearchedDistance(Index point, double sign, Index hint)>& search);

/// Returns the distance from `point` to `closest`, multiplied by `sign`, and its gradient.
SearchedDistance searched_distance(const Vec3& point, const Vec3& closest, double sign = 1);

}  // namespace transformesh
