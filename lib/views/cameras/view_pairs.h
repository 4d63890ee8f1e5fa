/// Chooses the pairs of photographs to compare.
/// Reference: Goesele, Snavely, Curless, Hoppe & Seitz, "Multi-View Stereo for Community Photo
/// Collections", ICCV 2007, for the angle as measure of a pair.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "transformesh/photo_step.h"
#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// An ordered pair of views: `first` is the reference, `second` is warped to it.
struct ViewPair {
  std::size_t first = 0;
  std::size_t second = 0;
  /// Angle at the scene's center between the directions to both cameras' centers.
  double angle_deg = 0;
};

/// Returns the best neighbors of each view, sorted by `first`, then by quality. A pair is better if
/// its angle is closer to 15 degrees; for smaller angles, the difference counts twice. Hence views
/// on a sparse ring get their nearest neighbors, and views on a dense ring get neighbors that are
/// far enough away. Views without a neighbor that `options` admit have no pair. Deterministic;
/// O(n^2 log n).
std::vector<ViewPair> choose_pairs(std::span<const PinholeCamera> cameras, const Vec3& scene_center,
                                   const PairOptions& options = {});

}  // namespace transformesh
