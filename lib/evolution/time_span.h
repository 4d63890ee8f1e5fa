/// Chooses the span of time of a step (evolve_in_time.h).
#pragma once

#include <span>
#include <vector>

#include "evolution/integration.h"

namespace transformesh {

/// A span of time and what the vertices do in it.
struct TrialStep {
  double span = 0;
  Integrated integrated;
  double max_move = 0;  ///< largest movement of a vertex, in mean lengths of its edges
};

/// Returns the largest length of a vector in units of `scales`, both by vertex. A vector at a
/// vertex with scale 0, which has no edges, does not count.
double largest_share(std::span<const Vec3> vectors, std::span<const double> scales);

/// Returns the step that ends at `time + remaining` at the latest. With `options.span` > 0 it has
/// that span. Otherwise no vertex moves by more than `options.max_move` of the mean length of its
/// edges `edge_means`, the error is at most `options.tolerance`, and the span is at most
/// `longest`. Throws GoalError if such a span is shorter than 1e-12 of `options.end`.
TrialStep chosen_step(const Integration& integration, const TimeOptions& options, double remaining,
                      double longest, std::span<const double> edge_means);

/// Returns the same step over another span, with its measures.
TrialStep step_over(const Integration& integration, double span,
                    std::span<const double> edge_means);

}  // namespace transformesh
