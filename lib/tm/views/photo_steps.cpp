#include "tm/views/photo_steps.h"

#include "tm/support/error.h"

namespace transformesh {
namespace {

constexpr double least_coverage_kept = 0.8;

std::vector<ViewPair> one_order(const std::vector<ViewPair>& pairs, bool lower_first) {
  std::vector<ViewPair> result;
  for (const ViewPair& pair : pairs) {
    if ((pair.first < pair.second) == lower_first) result.push_back(pair);
  }
  return result;
}

}  // namespace

PhotoStepsResult photo_steps(Mesh& mesh, const PhotoScene& scene, const PhotoStepsOptions& options,
                             const Progress& progress) {
  if (options.iterations < 1) throw UsageError("at least one iteration is needed");
  PhotoScene compared = scene;
  PhotoStepsResult result;
  std::array<std::size_t, 2> first_pixels{};
  for (int i = 0; i < options.iterations; ++i) {
    const int order = options.alternate ? i % 2 : 0;
    if (options.alternate) compared.pairs = one_order(scene.pairs, order == 0);
    result.last = photo_step(mesh, compared, options.step, progress);
    if (i == 0) result.first = result.last;
    if (i == order) first_pixels[static_cast<std::size_t>(order)] = result.last.pixels;
    const auto before = static_cast<double>(first_pixels[static_cast<std::size_t>(order)]);
    result.lost_coverage = static_cast<double>(result.last.pixels) < least_coverage_kept * before;
  }
  return result;
}

}  // namespace transformesh
