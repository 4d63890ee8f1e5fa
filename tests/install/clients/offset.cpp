// Offsets a unit sphere outwards by 0.2 and compares the volume with the sphere of radius 1.2.
#include <transformesh/offset.h>
#include <transformesh/shapes.h>

#include <cmath>

using namespace transformesh;

int main() {
  Document document{.mesh = make_sphere(Vec3::Zero(), 1, 1000)};
  const OffsetResult result = offset(document, {.distance = 0.2, .edge = 0.15});
  if (!result.is_done() || result.iterations == 0 || result.edge != 0.15) return 1;
  if (result.topology != Topology{1, 0} || result.deviation.most > 0.03) return 1;
  if (std::abs(volume(document.mesh) - 4 * std::acos(-1.0) / 3 * 1.728) > 0.2) return 1;
  try {
    offset(document, {});
  } catch (const UsageError&) {
    return offset_edge(document.mesh, 0.2) <= 0.1 ? 0 : 1;
  }
  return 1;
}
