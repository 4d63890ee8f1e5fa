// Tracks a sphere through targets of radius 1.05 and 1.1 and compares the final volume.
#include <transformesh/shapes.h>
#include <transformesh/track.h>

#include <cmath>

using namespace transformesh;

int main() {
  Document document{.mesh = make_sphere(Vec3::Zero(), 1, 500)};
  std::vector<std::size_t> asked;
  const auto target_of = [&](std::size_t frame) {
    asked.push_back(frame);
    return make_target(make_sphere(Vec3::Zero(), frame == 0 ? 1.05 : 1.1, 1000));
  };
  const TrackResult result = track(document, {"small", "large"}, target_of);
  if (result.frames != 2 || result.converged != 2) return 1;
  if (asked != std::vector<std::size_t>{0, 1}) return 1;
  return std::abs(volume(document.mesh) - 4 * std::acos(-1.0) / 3 * 1.331) < 0.3 ? 0 : 1;
}
