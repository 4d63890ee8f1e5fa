/// Samples a signed distance function at many points: exactly where the distance is small, and by
/// estimates elsewhere. A morph clamps the movement of far vertices, so that it needs no exact
/// distances there and most searches can be skipped.
///
/// Points are visited along a Hilbert curve. A distance function has Lipschitz constant 1, so that
/// the last search bounds the distance of the next point. If that distance certainly exceeds
/// `exact_within`, there are two cases. If the point is nearer to the point of the last search than
/// two fifths of the found distance, it gets a linear estimate. Otherwise a new search finds a
/// distance that is at most 5 % too large, and the sign of the last search is kept. Estimates are
/// typically right to a few percent, also on average. Signs are right if the function is
/// continuous. Deterministic for any number of threads. Cost: O(n log n) plus the searches.
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

/// Largest relative error of a search far from the surface. Larger values save time, and move the
/// limit beyond which points count as far.
inline constexpr double far_tolerance = 0.05;

/// Returns the distance of each point. `order` must be hilbert_order() of the points. `search`
/// receives the index of a point and is called from several threads. If `sign` is 0, it must return
/// the exact distance; otherwise `sign` is the sign of the distance, and the result may be too
/// large by far_tolerance. `hint` is the closest face of a nearby point, or no_index.
std::vector<double> sample_distance(
    std::span<const Vec3> points, std::span<const Index> order, double exact_within,
    const std::function<SearchedDistance(Index point, double sign, Index hint)>& search);

/// Returns the distance from `point` to `closest`, multiplied by `sign`, and its gradient.
SearchedDistance searched_distance(const Vec3& point, const Vec3& closest, double sign = 1);

}  // namespace transformesh
