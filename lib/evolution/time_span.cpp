#include "evolution/time_span.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/elementary/exponential.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Shortest time span of a step, as a fraction of the end time. A million steps of this span would
/// change the time by only 1e-6 of the end time: the evolution would not end.
constexpr double shortest_span = 1e-12;

/// Safety factor of the estimated span at which movement or error reaches its limit, so that the
/// next trial rarely exceeds the limit. Hairer, Norsett & Wanner, "Solving ordinary differential
/// equations I", section II.4, recommend 0.8 to 0.9.
constexpr double safety = 0.9;

/// Largest growth factor of the time span from one step to the next. If the longer span fails, one
/// evaluation is lost. With smaller factors, more steps are needed after a fast motion ends.
constexpr double span_growth = 1.5;

/// Returns the longest span of at most `span` that divides `remaining` into equal steps. Hence the
/// last step is not much shorter than the others.
double divided(double remaining, double span) {
  constexpr double tiny = 1e-9;  // relative rounding error of the division
  if (!(span < remaining)) return remaining;
  return remaining / std::ceil(remaining / span - tiny);
}

bool is_accepted(const TrialStep& trial, const TimeOptions& options) {
  return trial.max_move <= options.max_move &&
         (options.tolerance <= 0 || trial.integrated.error <= options.tolerance);
}

/// Returns the factor by which the span must be multiplied to bring movement and error a little
/// below their limits. Both are assumed to grow with the span as they do for short spans.
double allowed_factor(const TrialStep& trial, const TimeOptions& options) {
  double factor = std::numeric_limits<double>::infinity();
  if (trial.max_move > 0) factor = safety * options.max_move / trial.max_move;
  const double error = trial.integrated.error;
  if (options.tolerance > 0 && error > 0) {
    const double power = 1.0 / error_order(options.integrator);
    factor = std::min(factor, safety * elementary::pow(options.tolerance / error, power));
  }
  return factor;
}

}  // namespace

double largest_share(std::span<const Vec3> vectors, std::span<const double> scales) {
  double largest = 0;
  for (std::size_t v = 0; v < vectors.size(); ++v)
    if (scales[v] > 0) largest = std::max(largest, vectors[v].norm() / scales[v]);
  return largest;
}

TrialStep step_over(const Integration& integration, double span,
                    std::span<const double> edge_means) {
  TrialStep step{span, integration.over(span)};
  step.max_move = largest_share(step.integrated.displacements, edge_means);
  return step;
}

TrialStep chosen_step(const Integration& integration, const TimeOptions& options, double remaining,
                      double longest, std::span<const double> edge_means) {
  if (options.span > 0) {
    constexpr double tiny = 1e-9;  // relative rounding error of the sum of spans
    const bool is_last = remaining <= options.span * (1 + tiny);
    const double span = is_last ? remaining : options.span;
    return step_over(integration, std::min(span, longest), edge_means);
  }
  const double speed = largest_share(integration.initial_velocities(), edge_means);
  // Choose a first span over which vertices move a little less than allowed, because later stages
  // may move them farther. A second trial would cost as much as the first.
  const double limit = safety * options.max_move;
  double span = speed > 0 ? std::min(longest, limit / speed) : longest;
  for (;;) {
    span = divided(remaining, span);
    if (span < shortest_span * options.end) {
      throw GoalError("steps became shorter than " + significant(shortest_span * options.end, 3) +
                      ": the motion is too fast for the edges or the tolerance");
    }
    TrialStep trial = step_over(integration, span, edge_means);
    if (is_accepted(trial, options)) return trial;
    // Shrink the span at most to a tenth at once, since estimates are unreliable for long spans.
    span *= std::clamp(allowed_factor(trial, options), 0.1, safety);
  }
}

double next_span(const TrialStep& step, const TimeOptions& options) {
  return std::min(span_growth, allowed_factor(step, options)) * step.span;
}

}  // namespace transformesh
