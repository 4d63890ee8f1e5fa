#include "reconstruction/first_scale.h"

#include <algorithm>

namespace transformesh {
namespace {

/// Excess above which a vertex counts as wrong, and tolerated share of such vertices by weight of
/// windows. In four generated scenes the shares were up to 5.3 % on the true surface and on
/// decimated ones, and at least 8.6 % on smoothed and noisy surfaces and on hulls. A smaller share
/// sends accurate starts through coarse scales, a larger one leaves rough starts at a fine scale.
constexpr double wrong_excess = 0.3;
constexpr double most_wrong = 0.08;
/// Ratio within which disagreements count as equal. The coarsest of equal scales finds the largest
/// errors.
constexpr double equal_ratio = 1.05;

std::vector<bool> wrong_vertices(const std::vector<WindowSums>& sums) {
  std::vector<bool> is_wrong;
  for (const WindowSums& windows : sums)
    is_wrong.push_back(windows.weight > 0 && windows.excess() > wrong_excess);
  return is_wrong;
}

WindowSums sum_of(const std::vector<WindowSums>& sums, const std::vector<bool>& is_chosen) {
  WindowSums sum;
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (is_chosen[v]) sum += sums[v];
  return sum;
}

}  // namespace

double first_scale(const std::vector<double>& scales,
                   const std::function<std::vector<WindowSums>(double scale)>& disagreement_at) {
  const std::vector<WindowSums> at_full_scale = disagreement_at(scales.back());
  const std::vector<bool> is_wrong = wrong_vertices(at_full_scale);
  const WindowSums all = sum_of(at_full_scale, std::vector<bool>(is_wrong.size(), true));
  const WindowSums wrong = sum_of(at_full_scale, is_wrong);
  if (wrong.weight <= most_wrong * all.weight) return scales.back();

  std::vector<double> dissimilarities;
  for (const double scale : scales) {
    const WindowSums sum =
        scale == scales.back() ? wrong : sum_of(disagreement_at(scale), is_wrong);
    dissimilarities.push_back(sum.weight > 0 ? sum.dissimilarity() : 2);
  }
  const double least = *std::min_element(dissimilarities.begin(), dissimilarities.end());
  const auto found = std::find_if(dissimilarities.begin(), dissimilarities.end(),
                                  [&](double value) { return value <= equal_ratio * least; });
  return scales[static_cast<std::size_t>(found - dissimilarities.begin())];
}

}  // namespace transformesh
