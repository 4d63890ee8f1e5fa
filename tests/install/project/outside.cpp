// A project that uses the installed library: a surface grows until its components merge.
#include <transformesh/transformesh.h>

using namespace transformesh;

int main(int, char** argv) {
  Mesh mesh = clean(read_mesh_file(argv[1])).mesh;
  remesh(mesh, {.min_edge = 0.1, .max_edge = 0.2});
  const Velocity grow = [](const Mesh& now, const Progress&) {
    return normal_velocities(now, 0.05);
  };
  evolve(mesh, step_along(grow), EvolveOptions(), {.iterations = 8});
  write_mesh_file(argv[2], mesh);
}
