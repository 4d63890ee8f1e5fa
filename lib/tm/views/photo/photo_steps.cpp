#include "tm/views/photo/photo_steps.h"

#include <array>

#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr double least_share_kept = 0.9;
constexpr double least_pixels_kept = 0.5;

bool is_lost(const PhotoStepResult& before, const PhotoStepResult& after) {
  return after.coverage < least_share_kept * before.coverage ||
         static_cast<double>(after.pixels) < least_pixels_kept * static_cast<double>(before.pixels);
}

}  // namespace

PhotoStepsResult photo_steps(Mesh& mesh, const PhotoScene& scene, const PhotoStepsOptions& options,
                             const Progress& progress) {
  if (options.iterations < 1) throw UsageError("at least one iteration is needed");
  PhotoStepOptions step = options.step;
  PhotoStepsResult result;
  std::array<PhotoStepResult, 2> first_of_order;
  for (int i = 0; i < options.iterations; ++i) {
    const int order = options.alternate ? i % 2 : 0;
    if (options.alternate) step.order = order == 0 ? PairOrder::rising : PairOrder::falling;
    result.last = photo_step(mesh, scene, step, progress);
    if (i == 0) result.first = result.last;
    PhotoStepResult& before = first_of_order[static_cast<std::size_t>(order)];
    if (i == order) before = result.last;
    result.lost_coverage = is_lost(before, result.last);
  }
  return result;
}

}  // namespace transformesh
