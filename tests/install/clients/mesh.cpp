// Builds a tetrahedron by hand and checks sources, targets and neighbors of its halfedges.
#include <transformesh/mesh.h>

using namespace transformesh;

int main() {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (Index h = 0; h < 12; ++h) {
    if (halfedge_source(mesh, h) != mesh.faces[h / 3][h % 3]) return 1;
    if (halfedge_target(mesh, h) != mesh.faces[h / 3][(h + 1) % 3]) return 1;
    if (previous_halfedge(next_halfedge(h)) != h || next_halfedge(h) / 3 != h / 3) return 1;
    Index opposites = 0;
    for (Index other = 0; other < 12; ++other)
      if (halfedge_source(mesh, other) == halfedge_target(mesh, h) &&
          halfedge_target(mesh, other) == halfedge_source(mesh, h))
        ++opposites;
    if (opposites != 1) return 1;
  }
  return is_collapsed({1, 2, 1}) && !is_collapsed({1, 2, 3}) && no_index > 12 ? 0 : 1;
}
