/// Depths for which both the photographs and the neighboring pixels speak: matching costs of all
/// planes, added up along paths.
/// Reference: Hirschmueller, "Stereo processing by semiglobal matching and mutual information",
/// PAMI 30(2), 2008.
///
/// Along a path from the border of the image to a pixel and plane, the cheapest choice of planes
/// costs the sum of their matching costs, `near_step` wherever the next pixel has a neighboring
/// plane, and `far_step` where it has another. The result is the sum over the paths from eight
/// directions. So what a pixel alone leaves open, where there is gloss or little texture, those
/// around it decide.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace transformesh {

/// For each pixel of a rectangle, row by row, the costs of all planes, from 0 to 1; 1 where nothing
/// was compared. A pixel with 1 for all planes shows nothing: paths end before it.
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
  float near_step = 0.1F;  ///< >= 0
  float far_step = 2;      ///< >= near_step
};

/// O(pixels * planes) in time and memory; deterministic. Where a pixel shows nothing, 0.
MatchingCosts semiglobal_costs(const MatchingCosts& costs, const SemiglobalOptions& options = {});

}  // namespace transformesh
