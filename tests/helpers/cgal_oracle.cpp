#include "helpers/cgal_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <stdexcept>

namespace transformesh::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

SurfaceMesh surface_mesh(const Mesh& mesh) {
  SurfaceMesh surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : mesh.faces) {
    const auto face = surface.add_face(SurfaceMesh::Vertex_index(a), SurfaceMesh::Vertex_index(b),
                                       SurfaceMesh::Vertex_index(c));
    if (face == SurfaceMesh::null_face()) throw std::invalid_argument("not an oriented manifold");
  }
  return surface;
}

}  // namespace

std::size_t count_self_intersections(const Mesh& mesh) {
  const SurfaceMesh surface = surface_mesh(mesh);
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
      surface, std::back_inserter(pairs));
  return pairs.size();
}

}  // namespace transformesh::test
