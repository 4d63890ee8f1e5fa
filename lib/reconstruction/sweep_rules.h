/// What a reconstruction decides around a sweep (paper 5.3): plain values in, a choice or a verdict
/// out.
#pragma once

#include <span>

#include "reconstruction/scale_rule.h"
#include "transformesh/reconstruction_options.h"
#include "views/cameras/view_pairs.h"

namespace transformesh {

/// Whether even the nearest of the views with which one is compared is on average more than 40
/// degrees apart. Pairs of the same first view stand together.
bool is_wide(std::span<const ViewPair> pairs);

/// Whether edges were too long, so that thin parts of the object are gone, and with them a
/// twentieth of the pixels that are compared. An initial mesh that was only too large loses fewer.
bool is_torn(std::size_t initial_pixels, std::size_t pixels_now);

/// Whether the surface flies apart in a sweep: more than 100 components, ten times those of the
/// initial mesh; or three tenths of the vertices outside of silhouettes, more than when the sweep
/// began; or less than three tenths of the pixels compared, half the share that it was. Such a
/// surface never comes back.
bool is_exploded(const Sweep& sweep, std::size_t initial_components);

/// Disagreement at which windows pull by a quarter, at last: `factor` times the mean, which is
/// the dissimilarity. 0: all pull alike.
double robust_loss(double factor, double dissimilarity);

}  // namespace transformesh
