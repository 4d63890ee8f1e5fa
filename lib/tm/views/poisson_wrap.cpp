#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tm/mesh/measure.h"
#include "tm/support/error.h"
#include "tm/views/wrap.h"
#include "tm/views/wrap_result.h"

namespace transformesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using PointMap = CGAL::First_of_pair_property_map<Oriented>;
using NormalMap = CGAL::Second_of_pair_property_map<Oriented>;

/// Across all points: the surface would have as many faces as the square of that.
constexpr double most_spacings = 2000;
constexpr unsigned neighbors = 6;  // that the spacing is measured to

std::vector<Oriented> oriented_points(std::span<const Vec3> points, std::span<const Vec3> normals) {
  std::vector<Oriented> cloud;
  for (std::size_t i = 0; i < points.size() && i < normals.size(); ++i) {
    if (normals[i].isZero()) continue;
    const Vec3 n = normals[i].normalized();
    cloud.emplace_back(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()),
                       Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  return cloud;
}

bool is_in_plane(const std::vector<Oriented>& cloud) {
  const auto& first = cloud.front().first;
  const auto is_apart = [&](const Oriented& oriented) { return oriented.first != first; };
  const auto second = std::find_if(cloud.begin(), cloud.end(), is_apart);
  if (second == cloud.end()) return true;
  const auto is_beside = [&](const Oriented& oriented) {
    return !CGAL::collinear(first, second->first, oriented.first);
  };
  const auto third = std::find_if(second, cloud.end(), is_beside);
  if (third == cloud.end()) return true;
  return std::all_of(third, cloud.end(), [&](const Oriented& oriented) {
    return CGAL::coplanar(first, second->first, third->first, oriented.first);
  });
}

double diagonal_of(std::span<const Vec3> points) {
  Mesh cloud;
  cloud.positions.assign(points.begin(), points.end());
  return bounding_box(cloud).diagonal();
}

Mesh mesh_of(const Polyhedron& surface) {
  Mesh mesh;
  std::unordered_map<const void*, Index> index;  // looked up only
  for (auto vertex = surface.vertices_begin(); vertex != surface.vertices_end(); ++vertex) {
    index.emplace(&*vertex, static_cast<Index>(mesh.positions.size()));
    const auto& point = vertex->point();
    mesh.positions.emplace_back(point.x(), point.y(), point.z());
  }
  for (auto facet = surface.facets_begin(); facet != surface.facets_end(); ++facet) {
    Face corners;
    auto halfedge = facet->facet_begin();
    for (Index& corner : corners) corner = index.at(&*(halfedge++)->vertex());
    mesh.faces.push_back(corners);
  }
  return mesh;
}

}  // namespace

Mesh poisson_wrap(std::span<const Vec3> points, std::span<const Vec3> normals) {
  std::vector<Oriented> cloud = oriented_points(points, normals);
  if (cloud.size() < 4) throw InputError("fewer than four points have normals");
  if (is_in_plane(cloud)) throw InputError("all points lie in one plane");
  // CGAL's own generator starts from the time of day.
  CGAL::get_default_random() = CGAL::Random(0);
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(
      cloud, neighbors, CGAL::parameters::point_map(PointMap()));
  if (diagonal_of(points) > most_spacings * spacing)
    throw GoalError("the points are too uneven for a surface: some may be far off, by mistake");
  Mesh mesh;
  try {
    Polyhedron surface;
    const bool is_done = CGAL::poisson_surface_reconstruction_delaunay(
        cloud.begin(), cloud.end(), PointMap(), NormalMap(), surface, spacing);
    if (is_done) mesh = mesh_of(surface);
  } catch (const CGAL::Failure_exception&) {
    // What it meets in hopeless input is told as an assertion; without a mesh, check_wrap refuses.
  }
  check_wrap(mesh);
  return mesh;
}

}  // namespace transformesh
