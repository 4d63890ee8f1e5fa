// Evaluates a motion that depends on time.
#include <transformesh/motion.h>

using namespace transformesh;

int main() {
  const Motion rising{[](const Mesh& mesh, const Moment& moment, const Progress&) {
    return std::vector<Vec3>(mesh.positions.size(), Vec3(0, 0, moment.time));
  }};
  Mesh mesh;
  mesh.positions.assign(3, Vec3::Zero());
  if (rising.displacement) return 1;
  const std::vector<Vec3> velocities = rising.velocity(mesh, {.time = 2}, Progress());
  return velocities.size() == 3 && velocities[2] == Vec3(0, 0, 2) ? 0 : 1;
}
