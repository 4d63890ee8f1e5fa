#include "geometry/component_around.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/search/closest_point.h"
#include "geometry/solid_angle_winding.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Returns a power of two for scaling coordinates, such that their fourth powers do not overflow.
double safe_scale(const Mesh& mesh, const Vec3& point) {
  const Box box = bounding_box(mesh);
  const double largest =
      box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).cwiseMax(point.cwiseAbs()).maxCoeff();
  return largest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1;
}

double distance_to(const Mesh& mesh, const Face& face, const Vec3& point, double scale) {
  const Vec3 query = point * scale;
  const auto corner = [&](int i) -> Vec3 { return mesh.positions[face[i]] * scale; };
  const Vec3 nearest = closest_point_of_triangle(query, corner(0), corner(1), corner(2)).point;
  return (nearest - query).norm() / scale;
}

bool contains(const Mesh& mesh, const std::vector<Index>& faces, const Vec3& point) {
  // Copy the faces with separate vertices: winding numbers do not depend on shared vertices.
  Mesh soup;
  for (const Index f : faces) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index vertex : mesh.faces[f]) soup.positions.push_back(mesh.positions[vertex]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  const BoundedWindingNumber winding = SolidAngleWinding(soup)(point);
  const bool is_on_surface = winding.error >= 0.25;
  return is_on_surface || std::abs(winding.number) > 0.5;
}

}  // namespace

ComponentAround component_around(const Mesh& mesh, const Vec3& point) {
  if (mesh.faces.empty()) throw InputError("the mesh has no faces");
  const Components all = connected_components(mesh);

  const double scale = safe_scale(mesh, point);
  std::vector<std::vector<Index>> faces(all.components.size());
  std::vector<double> distance(faces.size(), std::numeric_limits<double>::infinity());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    double& least = distance[all.of_face[f]];
    least = std::min(least, distance_to(mesh, mesh.faces[f], point, scale));
    faces[all.of_face[f]].push_back(f);
  }

  // Find the closest component that contains the point, or the closest component if none contains
  // it.
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distance[a] < distance[b]; });
  const auto found = std::find_if(order.begin(), order.end(),
                                  [&](std::size_t c) { return contains(mesh, faces[c], point); });
  const std::size_t chosen = found == order.end() ? order.front() : *found;

  ComponentAround result{std::vector<bool>(mesh.faces.size(), false), found != order.end(),
                         distance[chosen]};
  for (const Index f : faces[chosen]) result.faces[f] = true;
  return result;
}

}  // namespace transformesh
