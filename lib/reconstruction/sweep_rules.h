/// Decisions of a reconstruction before and after a sweep, which is one iteration of its loop
/// (paper 5.3). The functions depend on their arguments only.
#pragma once

#include <span>

#include "reconstruction/scale_rule.h"
#include "transformesh/reconstruction_options.h"
#include "views/cameras/view_pairs.h"

namespace transformesh {

/// True if the views are far apart: the angle between a view and the nearest of its pairs is above
/// 40 degrees on average. Pairs with the same first view must be consecutive.
bool is_wide(std::span<const ViewPair> pairs);

/// True if thin parts of the object were probably lost because edges were too long. The criterion
/// is that the number of compared pixels fell by more than a twentieth. If the initial mesh was
/// merely too large, the number falls by less.
bool is_torn(std::size_t initial_pixels, std::size_t pixels_now);

/// True if the surface falls apart in a sweep. Such a surface never recovers. One of three criteria
/// suffices. First, there are more than 100 components, and more than ten times those of the
/// initial mesh. Second, more than three tenths of the vertices are outside of silhouettes, and
/// more than when the sweep began. Third, less than three tenths of the pixels are compared, and
/// less than half of the fraction when the sweep began.
bool is_exploded(const Sweep& sweep, std::size_t initial_components);

/// Returns CorrelationOptions::robust for the last sweeps: `factor` times the mean disagreement
/// (`dissimilarity`). Windows with a disagreement of this value have a quarter of the full weight.
/// If it is 0, all windows have the full weight.
double robust_loss(double factor, double dissimilarity);

}  // namespace transformesh
