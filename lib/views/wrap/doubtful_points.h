/// Points of a sparse reconstruction that few photographs or large errors make doubtful.
#pragma once

#include <vector>

#include "transformesh/columns.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the points whose reprojection error is more than three times the median, ascending. If
/// noise along x and y is Gaussian, .2 % of all errors exceed that limit (Rayleigh distribution:
/// 2^-9). Mean errors over several photographs exceed it more rarely. Returns nothing if `errors`
/// is empty.
std::vector<Index> with_large_error(const std::vector<double>& errors);

/// Returns the points that were observed in fewer than three photographs, ascending. Two rays may
/// nearly meet by chance, although they belong to different points. Returns nothing if `lengths` is
/// empty, or if fewer than half of the points would be left.
std::vector<Index> with_short_track(const std::vector<double>& lengths);

/// Return the column of reprojection errors, or of numbers of photographs, by the names that
/// programs use. Empty if there is none.
std::vector<double> reprojection_errors(const Columns& columns);
std::vector<double> track_lengths(const Columns& columns);

}  // namespace transformesh
