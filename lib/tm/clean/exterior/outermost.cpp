#include "tm/clean/exterior/outermost.h"

#include <algorithm>

#include "tm/clean/exterior/winding_ray.h"
#include "tm/mesh/components.h"

namespace transformesh {
namespace {

// Whether w > 0 in front of the first face of each component, counting the faces given as kept.
std::vector<char> find_enclosed(const Mesh& mesh, const Components& components) {
  const auto soup = std::make_shared<const Soup>(make_soup(mesh));
  const Arrangement arrangement = arrange(soup, {}, Progress());
  const WindingRay ray(arrangement, BorderClosure(), components.components.size());
  std::vector<char> enclosed(components.components.size(), 0);
  std::vector<char> seen(components.components.size(), 0);
  for (std::size_t p = 0; p < arrangement.pieces.size(); ++p) {
    const Index component = components.of_face[soup->face_of[p]];
    if (seen[component]) continue;
    seen[component] = 1;
    enclosed[component] = ray.in_front_of(arrangement.pieces[p]) > 0;
  }
  return enclosed;
}

std::size_t drop(Mesh& mesh, const Components& components, const std::vector<char>& dropped) {
  const auto count = static_cast<std::size_t>(std::count(dropped.begin(), dropped.end(), 1));
  if (count == 0) return 0;
  std::vector<bool> keep(mesh.faces.size());
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = !dropped[components.of_face[f]];
  mesh = select_faces(mesh, keep);
  return count;
}

}  // namespace

std::size_t drop_enclosed_components(Mesh& mesh) {
  // A clean mesh has nothing inside but cavities and what floats in them.
  const Components components = connected_components(mesh);
  std::vector<char> is_cavity;
  for (const Component& c : components.components) {
    is_cavity.push_back(c.boundary_loops == 0 && c.volume < 0);
  }
  const std::size_t cavities = drop(mesh, components, is_cavity);
  if (cavities == 0) return 0;
  const Components solids = connected_components(mesh);
  return cavities + drop(mesh, solids, find_enclosed(mesh, solids));
}

}  // namespace transformesh
