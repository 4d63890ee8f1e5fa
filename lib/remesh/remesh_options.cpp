#include "transformesh/remesh_options.h"

#include <cmath>

#include "remesh/check_remesh_options.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// The least ratio of the longest to the shortest edge. With a smaller ratio, halves of split edges
/// would be collapsed again.
constexpr double least_ratio = 1.5;

/// Lengths that messages suggest differ from the limit by this share, and have four digits.
/// Rounding to four digits changes a length by at most half of this share, so suggested lengths are
/// always valid.
constexpr double margin = 1e-3;

void check_lengths(double min_edge, double max_edge) {
  if (!std::isfinite(min_edge) || !std::isfinite(max_edge) || min_edge <= 0) {
    throw UsageError("edge lengths must be positive: the shortest is " + shortest_text(min_edge) +
                     ", the longest " + shortest_text(max_edge));
  }
  if (max_edge < least_ratio * min_edge) {
    throw UsageError(
        "the longest edge " + shortest_text(max_edge) + " is below 1.5 times the " + "shortest " +
        shortest_text(min_edge) + ": edges that are split would be collapsed again; use at most " +
        significant(max_edge / least_ratio * (1 - margin), 4) + " for the shortest, or at least " +
        significant(min_edge * least_ratio * (1 + margin), 4) + " for the longest");
  }
}

}  // namespace

void check_options(const RemeshOptions& options) {
  check_lengths(options.min_edge, options.max_edge);
  if (!(std::isfinite(options.adaptive_error) && options.adaptive_error >= 0)) {
    throw UsageError("the error bound must be a positive length");
  }
  if (options.adaptive_error > 0 && !options.size_column.empty()) {
    throw UsageError("sizes come from a column or from curvature, not from both");
  }
  if (!(std::isfinite(options.min_film) && options.min_film >= 0))
    throw UsageError("the thickness of films to be kept must be a positive length");
  if (!(std::isfinite(options.pinch) && options.pinch >= 0))
    throw UsageError("the length of loops to be pinched off must be a positive length");
  if (options.pinch > 0 && options.only_smooth)
    throw UsageError(
        "smoothing alone cannot be combined with cutting of necks: do one after the other");
  const double first = options.smooth_first;
  const double second = options.smooth_second;
  if (options.only_smooth && options.smoothing == Smoothing::none)
    throw UsageError("only smoothing is allowed, but smoothing is off: nothing would be done");
  if (options.iterations < 0) throw UsageError("the number of iterations must not be negative");
  if (!(options.feature_angle_deg >= 0 && options.feature_angle_deg <= 180)) {
    throw UsageError("the feature angle " + shortest_text(options.feature_angle_deg) +
                     " is not from 0 to 180 degrees");
  }
  if (!(first >= 0 && first <= 1)) {
    throw UsageError("the smoothing factor " + shortest_text(first) + " is not between 0 and 1");
  }
  if (options.smoothing != Smoothing::bilaplace) return;
  if (!(second >= (first - 1) / 2 && second <= first / 2)) {
    throw UsageError("the second smoothing factor " + shortest_text(second) +
                     " would amplify noise: with the first factor " + shortest_text(first) +
                     " it must be between " + shortest_text((first - 1) / 2) + " and " +
                     shortest_text(first / 2));
  }
}

RemeshOptions curved_remeshing() {
  RemeshOptions options;
  options.curved = true;
  options.flip = FlipRule::angle;
  options.smoothing = Smoothing::none;
  return options;
}

}  // namespace transformesh
