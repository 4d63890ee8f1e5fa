#include "views/color/exposure_compensation.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <map>

namespace transformesh {
namespace {

// Values chosen by hand. A larger `intensity_variance`, in squared intensities, keeps gains closer
// to 1. Intensities below `least_intensity` or above `largest_intensity` are unreliable. A larger
// ratio of intensities than `most_different` is hardly caused by exposure.
constexpr double intensity_variance = 100;
constexpr float least_intensity = 8, largest_intensity = 247;
constexpr float most_different = 1.5F;  ///< largest ratio of intensities of a point in two views
constexpr double most_gain = 4;

/// Sums over the surface points that are visible in both of two views: the intensities in each
/// view, and the number of points.
struct Overlap {
  double first = 0, second = 0;
  double count = 0;
};

using ViewPairKey = std::pair<std::size_t, std::size_t>;
using Overlaps = std::map<ViewPairKey, Overlap>;

bool is_comparable(float a, float b) {
  return std::min(a, b) >= least_intensity && std::max(a, b) <= largest_intensity &&
         std::max(a, b) <= most_different * std::min(a, b);
}

Overlaps overlaps_of(std::span<const BestViewColors> seen, int channel) {
  Overlaps overlaps;
  for (const BestViewColors& colors : seen) {
    const std::size_t count = colors.count_good();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        const float a = colors.intensities(i)[channel];
        const float b = colors.intensities(j)[channel];
        if (!is_comparable(a, b)) continue;
        Overlap& overlap = overlaps[{colors.view(i), colors.view(j)}];
        overlap.first += a;
        overlap.second += b;
        ++overlap.count;
      }
    }
  }
  return overlaps;
}

/// The normal equations that determine the gains of all views for one color channel.
class Equations {
 public:
  /// Begins with the equation gain = 1 for each view, weighted like one common surface point. This
  /// equation alone determines the gain of a view that has no points in common with other views.
  explicit Equations(std::size_t views)
      : matrix_(static_cast<Eigen::Index>(views), static_cast<Eigen::Index>(views)),
        right_(Eigen::VectorXd::Ones(matrix_.rows())) {
    for (Eigen::Index i = 0; i < matrix_.rows(); ++i) entries_.emplace_back(i, i, 1);
  }

  void add(const ViewPairKey& pair, const Overlap& overlap) {
    const auto first = static_cast<Eigen::Index>(pair.first);
    const auto second = static_cast<Eigen::Index>(pair.second);
    const double weight = 1 / (overlap.count * intensity_variance);
    entries_.emplace_back(first, first, weight * overlap.first * overlap.first + overlap.count);
    entries_.emplace_back(second, second, weight * overlap.second * overlap.second + overlap.count);
    for (const auto& [row, column] : {std::pair(first, second), std::pair(second, first)})
      entries_.emplace_back(row, column, -weight * overlap.first * overlap.second);
    right_[first] += overlap.count;
    right_[second] += overlap.count;
  }

  Eigen::VectorXd solve() {
    matrix_.setFromTriplets(entries_.begin(), entries_.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix_).solve(right_);
  }

 private:
  Eigen::SparseMatrix<double> matrix_;
  Eigen::VectorXd right_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace

std::vector<Gain> compensate_exposure(std::span<const BestViewColors> seen, std::size_t views) {
  std::vector<Gain> gains(views, Gain::Ones());
  if (views == 0) return gains;
  for (int channel = 0; channel < 3; ++channel) {
    Equations equations(views);
    for (const auto& [pair, overlap] : overlaps_of(seen, channel)) equations.add(pair, overlap);
    const Eigen::VectorXd found = equations.solve();
    for (std::size_t i = 0; i < views; ++i) {
      const double gain = found[static_cast<Eigen::Index>(i)];
      gains[i][channel] = static_cast<float>(std::clamp(gain, 1 / most_gain, most_gain));
    }
  }
  return gains;
}

double largest_gain(std::span<const Gain> gains) {
  float largest = 1;
  for (const Gain& gain : gains)
    largest = std::max({largest, gain.maxCoeff(), gain.inverse().maxCoeff()});
  return largest;
}

}  // namespace transformesh
