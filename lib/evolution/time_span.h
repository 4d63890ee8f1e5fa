/// Chooses the time span of a step (evolve_in_time.h).
#pragma once

#include <span>
#include <vector>

#include "evolution/integration.h"

namespace transformesh {

/// A time span and the movement of the vertices in it.
struct TrialStep {
  double span = 0;
  Integrated integrated;
  double max_move = 0;  ///< largest movement of a vertex / mean length of its edges
};

/// Returns the largest ratio of vector length to scale over all vertices. Vertices with scale 0,
/// which have no edges, are skipped.
double largest_share(std::span<const Vec3> vectors, std::span<const double> scales);

/// Returns the next step, whose span is at most `remaining` and `longest`. If `options.span` > 0,
/// the step has that span, unless it would be longer than these. Otherwise no vertex moves by more
/// than `options.max_move` times the mean length of its edges (`edge_means`), and the error is at
/// most `options.tolerance`. Throws GoalError if that requires a span shorter than 1e-12 of
/// `options.end`.
TrialStep chosen_step(const Integration& integration, const TimeOptions& options, double remaining,
                      double longest, std::span<const double> edge_means);

/// Returns the longest span to try for the next step, if the error or an implicit integrator limits
/// spans. At this span the movement and the error are expected to be a little below their limits.
/// The span is at most 1.5 times that of `step`.
double next_span(const TrialStep& step, const TimeOptions& options);

/// Returns the step over the given time span, with its largest movement relative to `edge_means`.
TrialStep step_over(const Integration& integration, double span,
                    std::span<const double> edge_means);

}  // namespace transformesh
