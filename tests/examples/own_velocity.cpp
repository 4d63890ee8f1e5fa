// A whole evolution with a velocity of one's own: a ball in a vortex around the axis of z.
#include "transformesh/evolve.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  Mesh mesh = read_mesh_file(argv[1]);
  const Velocity vortex = [](const Mesh& now, const Progress&) {
    std::vector<Vec3> velocities;
    for (const Vec3& p : now.positions) velocities.push_back(Vec3(-p.y(), p.x(), 0) / p.norm());
    return velocities;
  };
  evolve(mesh, step_along(vortex), EvolveOptions(), {.iterations = 25});
  write_mesh_file(argv[2], mesh);
}
