#include "reconstruction/first_scale.h"

#include <algorithm>

namespace transformesh {
namespace {

/// Windows with a larger dissimilarity are more different than alike.
constexpr double different = 0.5;
/// Tolerated share of windows with a larger dissimilarity than `different`. On four generated
/// scenes the share at scale 1 was 0.001 to 0.035 on the true surface and on decimated ones. The
/// share was 0.038 to 0.57 on smoothed and noisy surfaces, spheres and hulls. At half of the limit,
/// the refinement of accurate meshes begins at unnecessarily coarse scales. At twice the limit, the
/// refinement of a hull with deep hollows begins at too fine a scale to find the hollows.
constexpr double most_different = 0.03;
/// Shares of different windows count as equal if their ratio is at most this. The coarsest of the
/// scales with equal shares is chosen, because it corrects the largest errors.
constexpr double equal_ratio = 1.05;

/// Returns the share of windows that belong to vertices with a dissimilarity above `different`; 1
/// if no windows are compared.
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
