#include "views/photo/photo_steps.h"

#include <array>
#include <utility>

#include "transformesh/displace.h"
#include "transformesh/errors.h"
#include "views/photo/photo_scene.h"
#include "views/photo/scene_step.h"

namespace transformesh {
namespace {

// Lower limits of two ratios of last to first step: of the compared fraction of pixels, and of the
// number of compared pixels. Coverage counts as lost if one ratio is below its limit.
constexpr double least_share_kept = 0.9;
constexpr double least_pixels_kept = 0.5;

bool is_lost(const PhotoStepResult& before, const PhotoStepResult& after) {
  return after.coverage < least_share_kept * before.coverage ||
         static_cast<double>(after.pixels) < least_pixels_kept * static_cast<double>(before.pixels);
}

/// Adds a fraction of the previous movement to each step (heavy-ball method).
class Momentum {
 public:
  Momentum(double share, double alpha) : share_(share), alpha_(alpha) {}

  /// Stores the positions before a step.
  void begin(const Mesh& mesh) {
    if (share_ > 0) before_ = mesh.positions;
  }
  /// Adds momentum to the movement of `mesh` since begin().
  void add(Mesh& mesh);

 private:
  double share_, alpha_;
  std::vector<Vec3> before_;
  std::vector<Vec3> ways_;  ///< movements of the previous step, with momentum; empty at first
};

// The sum of movement and momentum is limited like the movement of a single step, by
// PhotoStepOptions::alpha.
void Momentum::add(Mesh& mesh) {
  if (share_ == 0) return;
  const std::vector<Vec3> last = std::exchange(ways_, mesh.positions);
  for (std::size_t v = 0; v < ways_.size(); ++v) ways_[v] -= before_[v];
  if (last.empty()) return;
  for (std::size_t v = 0; v < ways_.size(); ++v) ways_[v] += share_ * last[v];
  mesh.positions = before_;
  displace(mesh, ways_, {1, alpha_});
}

}  // namespace

PhotoStepsResult photo_steps(Mesh& mesh, const PhotoScene& scene, const PhotoStepsOptions& options,
                             const Progress& progress) {
  if (options.iterations < 1) throw UsageError("at least one iteration is needed");
  if (!(options.momentum >= 0 && options.momentum < 1))
    throw UsageError("the momentum must be at least 0 and less than 1");
  PhotoStepOptions step = options.step;
  Momentum momentum(options.momentum, step.alpha);
  PhotoStepsResult result;
  std::array<PhotoStepResult, 2> first_of_order;
  for (int i = 0; i < options.iterations; ++i) {
    const int order = options.alternate ? i % 2 : 0;
    if (options.alternate) step.order = order == 0 ? PairOrder::rising : PairOrder::falling;
    momentum.begin(mesh);
    result.last = photo_step(mesh, scene, step, progress);
    if (i + 1 < options.iterations) momentum.add(mesh);
    if (i == 0) result.first = result.last;
    PhotoStepResult& before = first_of_order[static_cast<std::size_t>(order)];
    if (i == order) before = result.last;
    result.lost_coverage = is_lost(before, result.last);
  }
  return result;
}

}  // namespace transformesh
