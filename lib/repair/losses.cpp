#include "repair/losses.h"

#include <algorithm>

#include "geometry/search/closest_point.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Distance from the result, as a share of the diagonal, up to which a face counts as kept. A
/// larger one would hide thin parts that are lost, a smaller one would count rounding.
constexpr double kept_distance = 1e-6;

/// Per face, true if the middle of the face is not on the other mesh.
std::vector<char> lost_faces(const Mesh& before, const Mesh& after) {
  std::vector<char> is_lost(before.faces.size(), 1);
  if (after.faces.empty()) return is_lost;
  const ClosestPointQuery query(after);
  const double distance = kept_distance * diagonal_of(bounding_box(before));
  for (Index f = 0; f < is_lost.size(); ++f) {
    const auto& [a, b, c] = before.faces[f];
    const Vec3 middle = (before.positions[a] + before.positions[b] + before.positions[c]) / 3;
    is_lost[f] = query.face_within(middle, distance) == no_index ? 1 : 0;
  }
  return is_lost;
}

/// A corner of the largest lost face of the component that lost most.
Vec3 place_of_largest(const Mesh& mesh, const std::vector<char>& is_lost) {
  const Components parts = connected_components(mesh);
  std::vector<double> lost(parts.components.size(), 0);
  for (Index f = 0; f < is_lost.size(); ++f)
    if (is_lost[f]) lost[parts.of_face[f]] += face_area(mesh, f);
  const auto most = static_cast<Index>(std::ranges::max_element(lost) - lost.begin());
  Index largest = no_index;
  for (Index f = 0; f < is_lost.size(); ++f) {
    if (!is_lost[f] || parts.of_face[f] != most) continue;
    if (largest == no_index || face_area(mesh, f) > face_area(mesh, largest)) largest = f;
  }
  return largest == no_index ? Vec3::Zero().eval() : mesh.positions[mesh.faces[largest][0]];
}

}  // namespace

Sizes sizes_of(const Mesh& mesh) {
  Sizes sizes{surface_area(mesh), 0};
  for (const Component& part : connected_components(mesh).components)
    if (part.boundary_loops == 0) sizes.volume += part.volume;
  return sizes;
}

Loss find_loss(const Mesh& before, const Mesh& after) {
  const std::vector<char> is_lost = lost_faces(before, after);
  double lost = 0;
  for (Index f = 0; f < is_lost.size(); ++f)
    if (is_lost[f]) lost += face_area(before, f);
  if (lost == 0) return {};
  return {lost / surface_area(before), place_of_largest(before, is_lost)};
}

Vec3 first_change(const Mesh& before, const Mesh& after) {
  const auto corner = [](const Mesh& mesh, Index f, int i) -> const Vec3& {
    return mesh.positions[mesh.faces[f][static_cast<std::size_t>(i)]];
  };
  const auto common = static_cast<Index>(std::min(before.faces.size(), after.faces.size()));
  for (Index f = 0; f < common; ++f)
    for (int i = 0; i < 3; ++i)
      if (corner(before, f, i) != corner(after, f, i)) return corner(before, f, i);
  if (common < before.faces.size()) return corner(before, common, 0);
  return common < after.faces.size() ? corner(after, common, 0) : Vec3::Zero();
}

}  // namespace transformesh
