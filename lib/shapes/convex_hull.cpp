#include "shapes/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <map>

#include "transformesh/errors.h"

namespace transformesh::shapes {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hull = CGAL::Surface_mesh<Kernel::Point_3>;
using Place = std::array<double, 3>;

/// Numbers the vertices in the order of the points, and sorts the faces, so that the result does
/// not depend on the order in which CGAL stores them.
Mesh in_order_of(const std::vector<Vec3>& points, const Hull& hull) {
  std::map<Place, Index> numbers;
  for (const auto v : hull.vertices()) {
    const auto& p = hull.point(v);
    numbers.emplace(Place{p.x(), p.y(), p.z()}, no_index);
  }
  Mesh mesh;
  for (const Vec3& p : points) {
    const auto found = numbers.find({p.x(), p.y(), p.z()});
    if (found == numbers.end() || found->second != no_index) continue;
    found->second = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(p);
  }
  for (const auto f : hull.faces()) {
    Face face{};
    std::size_t i = 0;
    for (const auto v : hull.vertices_around_face(hull.halfedge(f))) {
      const auto& p = hull.point(v);
      face[i++] = numbers.at({p.x(), p.y(), p.z()});
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    mesh.faces.push_back(face);
  }
  std::sort(mesh.faces.begin(), mesh.faces.end());
  return mesh;
}

bool are_coplanar(const std::vector<Kernel::Point_3>& points) {
  if (points.size() < 4) return true;
  const auto& first = points.front();
  const auto& last = points.back();
  const auto third =
      std::ranges::find_if(points, [&](const auto& p) { return !CGAL::collinear(first, last, p); });
  if (third == points.end()) return true;
  return std::ranges::all_of(points,
                             [&](const auto& p) { return CGAL::coplanar(first, last, *third, p); });
}

}  // namespace

Mesh convex_hull(const std::vector<Vec3>& points) {
  std::vector<Kernel::Point_3> all;
  all.reserve(points.size());
  for (const Vec3& p : points) all.emplace_back(p.x(), p.y(), p.z());
  // Equal points count once, and so do -0 and 0.
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (are_coplanar(all)) throw InputError("the points lie in one plane: their hull has no volume");
  Hull hull;
  CGAL::convex_hull_3(all.begin(), all.end(), hull);
  return in_order_of(points, hull);
}

}  // namespace transformesh::shapes
