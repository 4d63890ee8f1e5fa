#include "step/registration.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "support/counted.h"
#include "support/parallel.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr std::size_t samples_per_task = 256;  ///< affects time only
/// Cosine of 60 degrees. Points whose normals differ by a larger angle lie on different sides of a
/// thin part and are not paired. Noise of a quarter of an edge length changes normals by a smaller
/// angle.
constexpr double least_cosine = 0.5;
/// Least number of pairs. Six unknowns need six equations; fewer than 20 pairs are coincidental.
constexpr std::size_t least_pairs = 20;
/// Least share of the samples in the overlap. At 0.05, noisy meshes are aligned by small parts that
/// fit anywhere. With larger values, meshes that share only a small part are not aligned.
constexpr double least_overlap = 0.2;
/// Distance at which the weight of a pair becomes 0, in root mean square distances of the overlap.
/// At a distance of 2, noise counts as outliers; at 6, outliers distort the result.
constexpr double biweight_reach = 3;
/// Convergence: largest movement of a pair, in root mean square distances of the overlap. Because
/// pairs change, the mesh keeps moving by a few thousandths of this distance, and would not
/// converge with a smaller limit.
constexpr double rest_in_noise = 0.01;

}  // namespace

struct Registration::Pair {
  Vec3 point = Vec3::Zero();
  OrientedPoint partner;
  double squared_distance = 0;
  bool is_valid = false;
  double weight = 1;
};

Overlap overlap_of(const std::vector<double>& squared_distances, std::size_t samples) {
  const auto least = static_cast<std::size_t>(least_overlap * static_cast<double>(samples));
  const std::size_t first = std::min(least, squared_distances.size());
  Overlap best;
  double sum = 0;
  for (std::size_t k = 1; k <= squared_distances.size(); ++k) {
    sum += squared_distances[k - 1];
    if (k < first) continue;
    // The fractional mean square distance is mean_square / share^(2 lambda). Lambda is 3, as for
    // large outliers in Phillips, Liu & Tomasi. The added constant prevents a ranking of exact
    // matches by their rounding errors.
    const double share = static_cast<double>(k) / static_cast<double>(samples);
    const double mean_square = sum / static_cast<double>(k);
    const double cost = (mean_square + registration_rest * registration_rest) /
                        (share * share * share * share * share * share);
    if (best.count == 0 || cost < best.cost) best = {k, mean_square, cost};
  }
  return best;
}

namespace {

/// Sets the biweights of the pairs, and removes pairs with weight 0.
template <class Pairs>
void weigh(Pairs& pairs, double mean_square) {
  const double bound = biweight_reach * biweight_reach * mean_square;
  std::size_t count = 0;
  while (count < pairs.size() && pairs[count].squared_distance <= bound) {
    const double root = bound > 0 ? 1 - pairs[count].squared_distance / bound : 1;
    pairs[count++].weight = root * root;
  }
  pairs.resize(count);
}

template <class Pairs>
PlaneEquations equations_of(const Pairs& pairs) {
  const auto count = static_cast<double>(pairs.size());
  Vec3 center = Vec3::Zero();
  for (const auto& pair : pairs) center += pair.point / count;
  double square = 0;
  for (const auto& pair : pairs) square += (pair.point - center).squaredNorm() / count;
  if (!(square > 0)) throw GoalError("the mesh and the reference meet in a single point");
  PlaneEquations equations(center, std::sqrt(square));
  for (const auto& pair : pairs) {
    const Vec3& normal = pair.partner.normal;
    equations.add(pair.point, normal, normal.dot(pair.partner.position - pair.point), pair.weight);
  }
  return equations;
}

}  // namespace

Registration::Pair Registration::pair_of(const OrientedPoint& sample) const {
  const Vec3 point = motion_(sample.position);
  const auto [partner, is_on_border] = surface_.closest(point);
  const Vec3 normal = motion_.rotation * sample.normal;
  const bool faces_away = !normal.isZero(0) && normal.dot(partner.normal) < least_cosine;
  const bool is_valid = !is_on_border && !partner.normal.isZero(0) && !faces_away;
  return {point, partner, (partner.position - point).squaredNorm(), is_valid};
}

std::vector<Registration::Pair> Registration::sorted_pairs() const {
  if (samples_.size() < least_pairs)
    throw GoalError("the mesh has only " + counted(samples_.size(), "point") +
                    ", too few to align it: at least " + std::to_string(least_pairs) +
                    " points are needed");
  std::vector<Pair> pairs(samples_.size());
  parallel_for(samples_.size(), samples_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) pairs[i] = pair_of(samples_[i]);
  });
  std::erase_if(pairs, [](const Pair& pair) { return !pair.is_valid; });
  if (pairs.size() < least_pairs)
    throw GoalError("only " + counted(pairs.size(), "sample") + " of " +
                    std::to_string(samples_.size()) +
                    " lie on a part of the reference that faces the same way: the meshes do not "
                    "overlap, or one of them is inside out");
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.squared_distance < b.squared_distance;
  });
  return pairs;
}

Overlap Registration::overlap_of_pairs(const std::vector<Pair>& pairs) const {
  std::vector<double> distances;
  distances.reserve(pairs.size());
  for (const Pair& pair : pairs) distances.push_back(pair.squared_distance);
  return overlap_of(distances, samples_.size());
}

Overlap Registration::overlap() const { return overlap_of_pairs(sorted_pairs()); }

/// Performs one iteration. Returns the largest movement of a pair.
double Registration::improve() {
  std::vector<Pair> pairs = sorted_pairs();
  mean_square_ = overlap_of_pairs(pairs).mean_square;
  weigh(pairs, mean_square_);
  const auto [motion, stability] = equations_of(pairs).solve();
  stability_ = stability;
  motion_ = compose(motion, motion_);
  double moved = 0;
  for (const Pair& pair : pairs) moved = std::max(moved, (motion(pair.point) - pair.point).norm());
  return moved;
}

int Registration::run(int most, const std::function<void(int)>& report) {
  for (int iteration = 1; iteration <= most; ++iteration) {
    report(iteration);
    const double moved = improve();
    has_converged_ = moved < registration_rest || moved < rest_in_noise * std::sqrt(mean_square_);
    if (has_converged_) return iteration;
  }
  return most;
}

}  // namespace transformesh
