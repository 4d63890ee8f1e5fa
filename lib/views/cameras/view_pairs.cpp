#include "views/cameras/view_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "support/elementary/arctangent.h"

namespace transformesh {
namespace {

// Best angle of a pair of views. At smaller angles, windows of the photographs are more similar; at
// larger angles, they determine depth better.
constexpr double best_angle_deg = 15;
/// A pair of views whose angle is at most this is accepted, even if its angle exceeds
/// PairOptions::spread times the best angle.
constexpr double near_deg = 30;

double badness(const ViewPair& pair) {
  const double difference = pair.angle_deg - best_angle_deg;
  return difference < 0 ? -2 * difference : difference;
}

double angle_deg(const Vec3& first, const Vec3& second) {
  const double angle = elementary::atan2(first.cross(second).norm(), first.dot(second));
  return angle * 180 / std::numbers::pi;
}

void drop_distant(std::vector<ViewPair>& pairs, double spread) {
  if (pairs.empty()) return;
  const double widest_deg = std::max(near_deg, spread * pairs.front().angle_deg);
  std::erase_if(pairs, [&](const ViewPair& pair) { return pair.angle_deg > widest_deg; });
}

}  // namespace

std::vector<ViewPair> choose_pairs(std::span<const PinholeCamera> cameras, const Vec3& scene_center,
                                   const PairOptions& options) {
  std::vector<Vec3> directions;
  for (const PinholeCamera& camera : cameras)
    directions.emplace_back(camera.center() - scene_center);

  std::vector<ViewPair> pairs;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    std::vector<ViewPair> candidates;
    for (std::size_t j = 0; j < directions.size(); ++j) {
      const ViewPair pair{i, j, angle_deg(directions[i], directions[j])};
      const bool is_admissible =
          pair.angle_deg > options.minimum_angle_deg && pair.angle_deg < options.maximum_angle_deg;
      if (i != j && is_admissible) candidates.push_back(pair);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const ViewPair& a, const ViewPair& b) { return badness(a) < badness(b); });
    candidates.resize(std::min(candidates.size(), options.neighbors));
    drop_distant(candidates, options.spread);
    pairs.insert(pairs.end(), candidates.begin(), candidates.end());
  }
  return pairs;
}

}  // namespace transformesh
