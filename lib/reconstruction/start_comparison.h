/// Compares the surface of a reconstruction with the mesh that the caller gave as initial mesh (the
/// start).
///
/// Noise and blur of photographs limit the accuracy that they can confirm. Steps of a surface with
/// smaller errors fit noise: the dissimilarity falls although the surface gets worse. A result
/// therefore replaces a given start only if photographs agree clearly better on the result.
#pragma once

#include <string>
#include <vector>

#include "reconstruction/surface_doubt.h"
#include "transformesh/photo_step.h"

namespace transformesh {

/// Measures of a surface by photographs of full size (scale 1).
struct SurfaceMeasures {
  PhotoStepResult windows;  ///< measures of all compared windows
  SurfaceDoubt doubt;
  /// Intersection over union of the surface's outline and an exact mask, for each view that has
  /// such a mask.
  std::vector<double> outlines;

  /// Returns the mean of `outlines`, or 1 if there are none.
  double mean_outline() const;
};

/// True if `of_result` is lower than `of_start` by at least a fifth. Both are disagreements of
/// photographs beyond their noise (WindowSums::excess).
bool is_clearly_less(double of_result, double of_start);

/// Returns the reason why the start is kept, as a sentence, or "" if the result replaces the start.
/// The start is kept if the result has a larger dissimilarity. It is kept if the overlap of the
/// result with any exact mask is lower by more than 0.002. It is also kept unless at least one of
/// two measures improves clearly. These are the disagreement beyond noise, compared by
/// is_clearly_less(), and the mean overlap, which must increase by more than 0.002.
std::string reason_to_keep(const SurfaceMeasures& start, const SurfaceMeasures& result);

}  // namespace transformesh
