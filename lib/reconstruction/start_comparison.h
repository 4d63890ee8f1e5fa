/// Compares the surface of a reconstruction with the mesh that the caller gave as its start.
///
/// The photographs cannot distinguish surfaces that are nearer to the truth than their noise and
/// their sharpness allow. Steps then fit noise: the dissimilarity falls although the surface gets
/// worse. So a result replaces a given start only if it agrees clearly better.
#pragma once

#include <string>
#include <vector>

#include "reconstruction/surface_doubt.h"
#include "transformesh/photo_step.h"

namespace transformesh {

/// Measures of a surface at scale 1.
struct SurfaceMeasures {
  PhotoStepResult windows;  ///< measures of all compared windows
  SurfaceDoubt doubt;
  /// Intersection over union of the surface's outline and an exact mask, for each view that has
  /// such a mask.
  std::vector<double> outlines;

  /// Returns the mean of `outlines`, or 1 if there are none.
  double mean_outline() const;
};

/// True if a disagreement beyond noise (WindowSums::excess) is lower by at least a fifth.
bool is_clearly_less(double of_result, double of_start);

/// Returns the reason why the start is kept, as a sentence, or "" if the result replaces the start.
/// The start is kept if the result has a larger dissimilarity, or if the outline of the result
/// agrees by more than 0.002 less with a mask. The start is also kept if neither evidence improves
/// clearly: the disagreement beyond noise, by is_clearly_less(), and the mean agreement of
/// outlines, by more than 0.002.
std::string reason_to_keep(const SurfaceMeasures& start, const SurfaceMeasures& result);

}  // namespace transformesh
