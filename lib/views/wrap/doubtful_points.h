/// Finds points of a sparse reconstruction that are doubtful, because few photographs show them or
/// their reprojection error is large.
#pragma once

#include <vector>

#include "transformesh/columns.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the indices of points whose reprojection error is more than three times the median, in
/// ascending order. If noise along x and y is Gaussian, .2 % of the errors in single photographs
/// exceed that limit (Rayleigh distribution: 2^-9). The mean error of a point over several
/// photographs exceeds it more rarely. Returns nothing if `errors` is empty.
std::vector<Index> with_large_error(const std::vector<double>& errors);

/// Returns the indices of points that were observed in fewer than three photographs, in ascending
/// order. `lengths` are the numbers of photographs per point. Such points are doubtful because two
/// viewing rays may nearly meet by chance, although they belong to different points. Returns
/// nothing if `lengths` is empty, or if fewer than half of the points would be left.
std::vector<Index> with_short_track(const std::vector<double>& lengths);

/// Return the values of the column of reprojection errors or of numbers of photographs per point.
/// The column is found by the names that common programs give it. Return nothing if there is no
/// such column.
std::vector<double> reprojection_errors(const Columns& columns);
std::vector<double> track_lengths(const Columns& columns);

}  // namespace transformesh
