// Finds the two components of two separate spheres, splits them and selects the faces of one.
#include <transformesh/components.h>
#include <transformesh/shapes.h>

using namespace transformesh;

int main() {
  const Mesh mesh = make_shape({.kind = "two-spheres", .faces = 1000, .gap = 0.2});
  const Components found = connected_components(mesh);
  if (found.components.size() != 2 || found.genus() != 0) return 1;
  if (found.of_face.size() != mesh.faces.size() || found.components[0].euler() != 2) return 1;
  const std::vector<Mesh> parts = split_components(mesh, component_size_of("volume"));
  if (parts.size() != 2 || volume(parts[0]) < volume(parts[1])) return 1;
  std::vector<bool> keep(mesh.faces.size());
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = found.of_face[f] == 1;
  return select_faces(mesh, keep).faces.size() == found.components[1].faces ? 0 : 1;
}
