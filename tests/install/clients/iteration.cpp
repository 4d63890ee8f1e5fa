// Makes one iteration that translates a sphere by 0.02 and checks its center and topology.
#include <transformesh/iteration.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Document document{.mesh = make_sphere(Vec3::Zero(), 1, 1000)};
  const std::size_t vertices = document.mesh.positions.size();
  const Velocity up = [](const Mesh& now, const Progress&) {
    return std::vector<Vec3>(now.positions.size(), Vec3(0, 0, 0.02));
  };
  const IterationResult result = iterate(document, step_along(up), {.reference_edge = 0.17});
  if (result.vertices != vertices || result.faces != document.mesh.faces.size()) return 1;
  if (result.topology != Topology{1, 0} || result.was_cleaned || result.pairs != 0) return 1;
  if (result.displaced.moved != vertices) return 1;
  const Box box = bounding_box(document.mesh);
  if (smoothed_by(0.1).smoothing != Smoothing::laplace) return 1;
  return std::abs(box.min().z() + box.max().z() - 0.04) < 0.01 ? 0 : 1;
}
