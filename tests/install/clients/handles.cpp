// Removes the handle of a thin torus, after which the Euler characteristic is 2 instead of 0.
#include <transformesh/handles.h>
#include <transformesh/shapes.h>

using namespace transformesh;

// The Euler characteristic of a closed triangle mesh without isolated vertices, which has 3 F / 2
// edges.
static long euler(const Mesh& mesh) {
  return static_cast<long>(mesh.positions.size()) - static_cast<long>(mesh.faces.size() / 2);
}

int main() {
  Mesh mesh = make_shape({.kind = "torus", .faces = 1500, .radius = 1, .tube = 0.15});
  if (euler(mesh) != 0) return 1;
  Mesh same = mesh;
  if (remove_handles(same, {.max_length = 0.5}).removed != 0 || euler(same) != 0) return 1;
  const HandleResult result = remove_handles(mesh, {.max_length = 1.5});
  if (result.removed != 1 || result.new_faces == 0 || euler(mesh) != 2) return 1;
  try {
    remove_handles(mesh, {});
  } catch (const UsageError&) {
    return 0;
  }
  return 1;
}
