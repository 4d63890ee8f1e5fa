/// Decisions of a reconstruction before and after a sweep (paper 5.3), as functions of plain
/// values.
#pragma once

#include <span>

#include "reconstruction/scale_rule.h"
#include "transformesh/reconstruction_options.h"
#include "views/cameras/view_pairs.h"

namespace transformesh {

/// True if the views are far apart: the angle between a view and the nearest of its pairs is above
/// 40 degrees on average. Pairs of the same first view must be adjacent.
bool is_wide(std::span<const ViewPair> pairs);

/// True if edges were too long, so that thin parts of the object were lost. The criterion is that a
/// twentieth of the compared pixels was lost. An initial mesh that was merely too large loses
/// fewer.
bool is_torn(std::size_t initial_pixels, std::size_t pixels_now);

/// True if the surface disintegrates in a sweep. One of three criteria suffices. There are more
/// than 100 components, and ten times those of the initial mesh. Or more than three tenths of the
/// vertices are outside of silhouettes, and more than when the sweep began. Or less than three
/// tenths of the pixels are compared, and less than half of the fraction when the sweep began. Such
/// a surface never recovers.
bool is_exploded(const Sweep& sweep, std::size_t initial_components);

/// Returns CorrelationOptions::robust for the last sweeps: `factor` times the mean disagreement
/// (`dissimilarity`). Windows that disagree by this value pull by a quarter. 0: all windows pull
/// alike.
double robust_loss(double factor, double dissimilarity);

}  // namespace transformesh
