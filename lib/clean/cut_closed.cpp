// Cuts a solid at a plane and closes the cut. The result is the intersection of the solid with a
// prism whose base is in the plane, computed as the boundary of winding number 2. Cost: that of
// clean(), twice. Whether the plane meets the solid at all is decided exactly.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "clean/whole/clean_whole.h"
#include "geometry/plane_distances.h"
#include "mesh/triangle.h"
#include "transformesh/clean.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/select.h"

namespace transformesh {
namespace {

/// Least distance of the edges of the prism's triangular base from the center of the base, in
/// diagonals of the mesh's bounding box. The mesh reaches at most half a diagonal from this center.
/// A choice: any value above 1/2 gives the same cut, up to rounding.
constexpr double reach = 4;
/// Corners of the base, as multiples of two directions in the plane. The edges are at a distance of
/// at least 1 from the center.
constexpr std::array<std::array<double, 2>, 3> base_corners = {{{-2, -1}, {2, -1}, {0, 2}}};
constexpr const char* nothing_left =
    "nothing of the mesh lies on the side that the plane's normal points to";

/// Returns two directions perpendicular to a unit normal and to each other. If the normal is a
/// coordinate axis, so are both directions.
std::array<Vec3, 2> directions_across(const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Vec3 first = normal.cross(Vec3::Unit(axis)).normalized();
  return {first, normal.cross(first)};
}

/// Returns a prism whose base is a triangle in the plane. The prism contains the part of the box
/// that is in front of the plane.
Mesh prism_in_front(const CutPlane& plane, const Box& box) {
  const double length = plane.normal.stableNorm();
  if (!(length > 0) || !std::isfinite(length))
    throw UsageError("the normal of the plane has no direction: it needs a length other than 0");
  const Vec3 normal = plane.normal / length;
  const Vec3 middle = box.min() + (box.max() - box.min()) / 2;
  const double height = normal.dot(middle) - plane.offset / length;
  const double size = diagonal_of(box);
  const Vec3 center = middle - height * normal;
  const auto [u, v] = directions_across(normal);

  Mesh prism;
  for (const double top : {0.0, std::abs(height) + size})
    for (const auto& [x, y] : base_corners)
      prism.positions.emplace_back(center + reach * size * (x * u + y * v) + top * normal);
  prism.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                 {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return prism;
}

/// Moves the base of the prism into the plane exactly, if its corners can be doubles. Then the cap
/// meets the vertices and faces in the plane without slivers. The given point must be in the plane
/// and in the box. The directions of the base are cross products of the normal with coordinate
/// axes, multiplied by a power of two, and hence have no rounding error.
void place_base_exactly(Mesh& prism, const CutPlane& plane, const Box& box, const Vec3& point) {
  Eigen::Index k = 0;
  const double largest = plane.normal.cwiseAbs().maxCoeff(&k);
  const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
  int exponent = 0;
  std::frexp(reach * diagonal_of(box) / largest, &exponent);
  const double scale = std::ldexp(1.0, exponent);
  Vec3 u = Vec3::Zero(), v = Vec3::Zero();
  u[i] = v[j] = scale * plane.normal[k];
  u[k] = -scale * plane.normal[i];
  v[k] = -scale * plane.normal[j];
  if (plane.normal[k] < 0) std::swap(u, v);

  Mesh base;
  for (const auto& [x, y] : base_corners) base.positions.emplace_back(point + x * u + y * v);
  for (const Vec3& corner : base.positions)
    if (!corner.allFinite()) return;
  const PlaneDistances distances(base, plane);
  for (Index corner = 0; corner < 3; ++corner)
    if (distances[corner] != 0) return;
  const Vec3 height = prism.positions[3] - prism.positions[0];
  for (std::size_t corner = 0; corner < 3; ++corner) {
    prism.positions[corner] = base.positions[corner];
    prism.positions[corner + 3] = base.positions[corner] + height;
  }
}

/// Drops the components that are behind the plane or touch it from behind: they do not change the
/// part in front. The mesh must not intersect itself.
void drop_components_behind(Mesh& solid, const CutPlane& plane) {
  const PlaneDistances distances(solid, plane);
  const std::vector<Index> component = connected_components(solid).of_face;
  std::vector<bool> is_kept(solid.faces.size()), is_in_front(solid.faces.size());
  for (std::size_t f = 0; f < solid.faces.size(); ++f)
    for (const Index v : solid.faces[f])
      if (distances[v] > 0) is_in_front[component[f]] = true;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) is_kept[f] = is_in_front[component[f]];
  if (std::ranges::find(is_kept, true) == is_kept.end()) throw GoalError(nothing_left);
  if (std::ranges::find(is_kept, false) != is_kept.end()) solid = select_faces(solid, is_kept);
}

/// Contact of a plane and a solid.
struct PlaneContact {
  bool is_crossed = false;    ///< some vertex is behind the plane
  std::optional<Vec3> point;  ///< a vertex in the plane
};

PlaneContact contact_of(const Mesh& solid, const CutPlane& plane) {
  const PlaneDistances distances(solid, plane);
  PlaneContact contact;
  for (Index v = 0; v < solid.positions.size(); ++v) {
    contact.is_crossed = contact.is_crossed || distances[v] < 0;
    if (!contact.point && distances[v] == 0) contact.point = solid.positions[v];
  }
  return contact;
}

/// Appends a mesh; all its columns are zero.
void append(Mesh& mesh, const Mesh& part) {
  const auto offset = static_cast<Index>(mesh.positions.size());
  mesh.vertex_columns.concatenate({}, mesh.positions.size(), part.positions.size());
  mesh.face_columns.concatenate({}, mesh.faces.size(), part.faces.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const auto& [a, b, c] : part.faces)
    mesh.faces.push_back({a + offset, b + offset, c + offset});
}

}  // namespace

void cut_closed(Mesh& mesh, const CutPlane& plane, Scalar coordinate, const Progress& progress) {
  if (!check_manifold(mesh).is_closed())
    throw InputError(ErrorKind::not_closed,
                     "the mesh is open: a cut through it does not bound a solid");
  const Box box = bounding_box(mesh);
  Mesh prism = prism_in_front(plane, box);
  CleanOptions options;
  options.coordinate = coordinate;
  // Clean the mesh first: if it overlaps itself, the winding number in the overlap is 2 even
  // without the prism.
  Mesh solid = clean(mesh, options, progress).mesh;
  drop_components_behind(solid, plane);
  const PlaneContact contact = contact_of(solid, plane);
  if (!contact.is_crossed) {
    mesh = std::move(solid);
    return;
  }
  if (contact.point) place_base_exactly(prism, plane, box, *contact.point);
  append(solid, prism);
  options.winding_level = 2;
  try {
    // clean() would round the corners of the prism, which are not in the result.
    mesh = clean_whole(solid, options, progress).mesh;
  } catch (const GoalError& error) {
    if (error.kind() != ErrorKind::no_such_level) throw;
    throw GoalError(nothing_left);
  }
}

}  // namespace transformesh
