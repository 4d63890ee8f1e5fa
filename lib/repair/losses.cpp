#include "repair/losses.h"

#include <algorithm>

#include "geometry/search/closest_point.h"
#include "transformesh/components.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// A face counts as kept up to this distance from the other mesh, as a share of the bounding box
/// diagonal. With a larger limit, the loss of thin parts would not be noticed; with a smaller
/// limit, rounding would count as loss.
constexpr double kept_distance = 1e-6;

/// Returns a corner of the largest lost face of the component that lost the most area.
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

std::vector<char> faces_off(const Mesh& mesh, const Mesh& other) {
  std::vector<char> is_off(mesh.faces.size(), 1);
  if (other.faces.empty()) return is_off;
  const ClosestPointQuery query(other);
  const double distance = kept_distance * diagonal_of(bounding_box(mesh));
  for (Index f = 0; f < is_off.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    is_off[f] = query.face_within(middle, distance) == no_index ? 1 : 0;
  }
  return is_off;
}

Loss find_loss(const Mesh& before, const Mesh& after) {
  const std::vector<char> is_lost = faces_off(before, after);
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
