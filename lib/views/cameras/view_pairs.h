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
  double angle_deg = 0;  ///< between the cameras' centers, as seen from the scene's center
};

/// Returns the best neighbors of each view, sorted by `first`, then by quality. Quality is the
/// difference of the angle from 15 degrees, which counts twice for smaller angles. Hence views on a
/// sparse ring get their nearest neighbors, and views on a dense ring get neighbors that are far
/// enough away. Views without admissible neighbor have no pair. Deterministic; O(n^2 log n).
std::vector<ViewPair> choose_pairs(std::span<const PinholeCamera> cameras, const Vec3& scene_center,
                                   const PairOptions& options = {});

}  // namespace transformesh
