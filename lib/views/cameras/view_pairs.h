/// Which photographs to compare with each other.
/// Reference: the angle as measure of a pair as in Goesele, Snavely, Curless, Hoppe & Seitz,
/// "Multi-View Stereo for Community Photo Collections", ICCV 2007.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "transformesh/photo_step.h"
#include "transformesh/pinhole_camera.h"

namespace transformesh {

/// An ordered pair: view `first` is compared with what view `second` sees of its surface.
struct ViewPair {
  std::size_t first = 0;
  std::size_t second = 0;
  double angle_deg = 0;  ///< between the cameras' centers, seen from the scene's center
};

/// The best neighbors of each view, by `first` and then the best first. The best angle is 15
/// degrees; a narrower one is twice as bad as one that is wider by the same. So a sparse ring gets
/// the nearest views, and a dense one those that are far enough apart. Views without an admissible
/// neighbor have no pair. Deterministic; O(n^2 log n).
std::vector<ViewPair> choose_pairs(std::span<const PinholeCamera> cameras, const Vec3& scene_center,
                                   const PairOptions& options = {});

}  // namespace transformesh
