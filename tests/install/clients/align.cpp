// Turns a box and brings it back.
#include <transformesh/align.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const Mesh box = make_shape({.kind = "box", .parameters = {"1", "2", "3"}, .faces = 500});
  Mesh turned = box;
  transform(turned, rotation_about({0, 0, 1}, 10));
  const RegistrationResult result = align(turned, box);
  if (!result.has_converged || result.rotation_deg < 9.9 || result.rotation_deg > 10.1) return 1;
  return (turned.positions[0] - box.positions[0]).norm() < 1e-6 ? 0 : 1;
}
