#include "reconstruction/sweep_rules.h"

#include <algorithm>

#include "reconstruction/scale_rule.h"
#include "support/number.h"

namespace transformesh {
namespace {

// Limits of is_exploded() and is_wide(), described in the header.
constexpr std::size_t exploded_components = 100;
constexpr double exploded_share = 0.3;
constexpr double wide_deg = 40;

}  // namespace

int WindowRadii::at(double scale) const { return is_late_scale(scale) ? fine : coarse; }

bool is_wide(std::span<const ViewPair> pairs) {
  double sum = 0;
  double views = 0;
  for (std::size_t i = 0; i < pairs.size(); ++views) {
    double nearest = 180;
    const std::size_t view = pairs[i].first;
    for (; i < pairs.size() && pairs[i].first == view; ++i)
      nearest = std::min(nearest, pairs[i].angle_deg);
    sum += nearest;
  }
  return sum > wide_deg * views;
}

bool is_torn(std::size_t initial_pixels, std::size_t pixels_now) {
  return real_count(pixels_now) < 0.95 * real_count(initial_pixels);
}

bool is_exploded(const Sweep& sweep, std::size_t initial_components) {
  const PhotoStepResult& first = sweep.steps.first;
  const PhotoStepResult& last = sweep.steps.last;
  const std::size_t components = sweep.mesh.topology.components;
  if (components > exploded_components && components > 10 * initial_components) return true;
  if (real_count(last.outside) > exploded_share * real_count(sweep.mesh.vertices) &&
      last.outside > first.outside)
    return true;
  return last.coverage < exploded_share && last.coverage < first.coverage / 2;
}

double robust_loss(double factor, double dissimilarity) {
  const double loss = factor * dissimilarity;
  return loss > 0 ? read_back(significant(std::clamp(loss, 0.001, 1000.0), 9)) : 0;
}

}  // namespace transformesh
