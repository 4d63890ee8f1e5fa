/// Semiglobal matching: regularizes the costs of assigning a depth plane (plane_sweep.h) to each
/// pixel. Costs of neighboring pixels are added along paths.
/// Reference: Hirschmueller, "Stereo processing by semiglobal matching and mutual information",
/// PAMI 30(2), 2008.
///
/// A path leads from the border of the image to a pixel and plane. Its cost is the sum of the
/// matching costs of its planes and of the costs of its steps. A step costs nothing if both pixels
/// have the same plane, `near_step` if they have adjacent planes, and `far_step` otherwise. The
/// result for a pixel and plane is the sum of the costs of eight paths, the cheapest path from each
/// of eight directions. Hence pixels with ambiguous costs, on glossy surfaces or with little
/// texture, follow the pixels around them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace transformesh {

/// Costs of all planes for each pixel of a rectangle, row by row. Costs are in [0, 1], and 1 if
/// photographs were not compared. A pixel with cost 1 on all planes is empty and interrupts paths.
struct MatchingCosts {
  int columns = 0, rows = 0, planes = 0;
  std::vector<float> values = {};

  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  }
  std::span<float> at(int x, int y) { return {values.data() + offset(x, y), count()}; }
  std::span<const float> at(int x, int y) const { return {values.data() + offset(x, y), count()}; }

 private:
  std::size_t count() const { return static_cast<std::size_t>(planes); }
  std::size_t offset(int x, int y) const { return pixel(x, y) * count(); }
};

struct SemiglobalOptions {
  float near_step = 0.1F;  ///< cost of a step to an adjacent plane; >= 0
  float far_step = 2;      ///< cost of a step to any other plane; >= near_step
};

/// Returns the sums of path costs for each pixel and plane; 0 at empty pixels. O(pixels * planes)
/// time and memory; deterministic.
MatchingCosts semiglobal_costs(const MatchingCosts& costs, const SemiglobalOptions& options = {});

}  // namespace transformesh
