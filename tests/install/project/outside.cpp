// A project of somebody else, on the installed library: a surface blown up until its parts merge.
#include <clean/clean.h>
#include <evolution/evolve.h>
#include <io/mesh_io.h>
#include <remesh/remesh.h>
#include <step/velocity.h>

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
