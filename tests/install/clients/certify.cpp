// Certifies that a sphere is its own outer boundary and that a displaced sphere is not.
#include <transformesh/certify.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const Mesh sphere = make_sphere(Vec3::Zero(), 1, 500);
  const Mesh displaced = make_sphere(Vec3(0.1, 0, 0), 1, 500);
  const Certificate good = certify(sphere, sphere);
  const Certificate bad = certify(sphere, displaced);
  if (!good.holds() || !good.input_is_closed || good.samples == 0 || good.wrong > 0) return 1;
  return !bad.holds() && bad.wrong > 0 && !bad.problem.empty() ? 0 : 1;
}
