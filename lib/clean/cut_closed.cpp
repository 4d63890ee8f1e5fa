// Cuts a solid at a plane and closes the cut. The result is the intersection of the solid with a
// prism whose base is in the plane, computed as the boundary of winding number 2. Cost: that of
// clean(), twice.
#include <Eigen/Geometry>

#include "clean/whole/clean_whole.h"
#include "mesh/triangle.h"
#include "transformesh/clean.h"
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
    for (const auto& [x, y] : {std::pair(-2.0, -1.0), std::pair(2.0, -1.0), std::pair(0.0, 2.0)})
      prism.positions.emplace_back(center + reach * size * (x * u + y * v) + top * normal);
  prism.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                 {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return prism;
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
  const Mesh prism = prism_in_front(plane, bounding_box(mesh));
  CleanOptions options;
  options.coordinate = coordinate;
  // Clean the mesh first: if it overlaps itself, the winding number in the overlap is 2 even
  // without the prism.
  Mesh solid = clean(mesh, options, progress).mesh;
  append(solid, prism);
  options.winding_level = 2;
  try {
    // clean() would round the corners of the prism, which are not in the result.
    mesh = clean_whole(solid, options, progress).mesh;
  } catch (const GoalError& error) {
    if (error.kind() != ErrorKind::no_such_level) throw;
    throw GoalError("nothing of the mesh lies on the side that the plane's normal points to");
  }
}

}  // namespace transformesh
