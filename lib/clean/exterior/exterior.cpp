#include "clean/exterior/exterior.h"

#include <algorithm>
#include <string>

#include "clean/exterior/ray_cast_front_winding.h"
#include "geometry/inward_components.h"
#include "transformesh/components.h"

namespace transformesh {
namespace {

Problem nothing_enclosed(bool has_area) {
  const std::string what = "the faces enclose nothing: they ";
  if (!has_area) return {ErrorKind::no_area, what + "have no area"};
  return {ErrorKind::canceling_faces,
          what +
              "coincide with opposite orientation and cancel out, as in an empty difference or a "
              "sheet whose border is filled flat"};
}

// Returns 1 for each component that is inside another component: the winding number w in front of
// its first face is greater than 0.
std::vector<char> find_enclosed(const Mesh& mesh, const Components& components) {
  const WeldedMesh welded = weld(mesh);
  const ExactGeometry geometry(welded.points, welded.faces);
  const RayCastFrontWinding ray(welded, components.components.size());
  std::vector<char> enclosed(components.components.size(), 0);
  std::vector<char> seen(components.components.size(), 0);
  for (Index f = 0; f < welded.faces.size(); ++f) {
    const Index component = components.of_face[welded.face_of[f]];
    if (seen[component]) continue;
    seen[component] = 1;
    const auto& [a, b, c] = welded.faces[f];
    enclosed[component] =
        ray.in_front_of({geometry.given(a), geometry.given(b), geometry.given(c)}, f) > 0;
  }
  return enclosed;
}

std::size_t drop_components(Mesh& mesh, const Components& components,
                            const std::vector<char>& dropped) {
  const auto count = static_cast<std::size_t>(std::count(dropped.begin(), dropped.end(), 1));
  if (count == 0) return 0;
  std::vector<bool> keep(mesh.faces.size());
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = !dropped[components.of_face[f]];
  mesh = select_faces(mesh, keep);
  return count;
}

}  // namespace

std::vector<char> find_exterior_by_rays(const Arrangement& arrangement, int winding_level,
                                        const Progress& progress) {
  progress("exterior", 0.1);
  const RayCastFrontWinding ray(*arrangement.welded, arrangement.pieces.size());
  std::vector<char> kept;
  kept.reserve(arrangement.pieces.size());
  for (const Piece& piece : arrangement.pieces) {
    const int front = piece.multiplicity == 0 ? winding_level : ray.in_front_of(arrangement, piece);
    kept.push_back(front < winding_level && front + piece.multiplicity >= winding_level ? 1 : 0);
  }
  return kept;
}

Problem nothing_kept(const WeldedMesh& welded, bool has_surface, int winding_level) {
  if (winding_level != 1)
    return {ErrorKind::no_such_level,
            "no point has a winding number >= " + std::to_string(winding_level)};
  if (!has_surface) return nothing_enclosed(!welded.faces.empty());
  if (!welded.open_component.empty())
    return {ErrorKind::other,
            "every part of the open mesh lies behind another part: nothing is left"};
  return {ErrorKind::no_positive_winding,
          "no point has a winding number >= 1: the mesh is inside out, or the difference of its "
          "parts is empty"};
}

std::size_t drop_enclosed_components(Mesh& mesh) {
  return drop_enclosed_components(mesh, connected_components(mesh));
}

// A component of a clean mesh that is inside another component bounds a cavity, or is inside a
// cavity.
std::size_t drop_enclosed_components(Mesh& mesh, const Components& components) {
  const std::vector<char> is_cavity = inward_components(mesh, components);
  const std::size_t cavities = drop_components(mesh, components, is_cavity);
  if (cavities == 0) return 0;
  const Components solids = connected_components(mesh);
  return cavities + drop_components(mesh, solids, find_enclosed(mesh, solids));
}

}  // namespace transformesh
