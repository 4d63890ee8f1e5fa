#include "reconstruction/first_scale.h"

#include <algorithm>

namespace transformesh {
namespace {

/// Dissimilarity from which on windows are more different than alike.
constexpr double different = 0.5;
/// Tolerated share of different windows. On four generated scenes the share at scale 1 was 0.001 to
/// 0.035 on the true surface and on decimated ones. The share was 0.038 to 0.57 on smoothed and
/// noisy surfaces, spheres and hulls. Half of the limit sends accurate starts through coarse
/// scales. At twice the limit, a hull with deep hollows begins at a scale at which they are not
/// found.
constexpr double most_different = 0.03;
/// Ratio within which shares count as equal. The coarsest of equal scales finds the largest errors.
constexpr double equal_ratio = 1.05;

/// Returns the share of windows at vertices that disagree; 1 if nothing is compared.
double different_share(const std::vector<WindowSums>& sums) {
  double all = 0;
  double wrong = 0;
  for (const WindowSums& windows : sums) {
    all += windows.weight;
    if (windows.dissimilarity() > different) wrong += windows.weight;
  }
  return all > 0 ? wrong / all : 1;
}

}  // namespace

double first_scale(const std::vector<double>& scales,
                   const std::function<std::vector<WindowSums>(double scale)>& disagreement_at) {
  std::vector<double> shares(scales.size());
  for (std::size_t i = scales.size(); i-- > 0;) {
    shares[i] = different_share(disagreement_at(scales[i]));
    if (shares[i] <= most_different) return scales[i];
  }
  const double least = *std::min_element(shares.begin(), shares.end());
  const auto found = std::find_if(shares.begin(), shares.end(),
                                  [&](double share) { return share <= equal_ratio * least; });
  return scales[static_cast<std::size_t>(found - shares.begin())];
}

}  // namespace transformesh
