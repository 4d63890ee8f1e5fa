#include "helpers/cgal_boolean.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <map>
#include <stdexcept>

namespace transformesh::test {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

SurfaceMesh to_cgal(const Mesh& mesh) {
  SurfaceMesh surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : mesh.faces) {
    const auto face = surface.add_face(SurfaceMesh::Vertex_index(a), SurfaceMesh::Vertex_index(b),
                                       SurfaceMesh::Vertex_index(c));
    if (face == SurfaceMesh::null_face()) throw std::runtime_error("not an oriented manifold");
  }
  return surface;
}

Mesh from_cgal(SurfaceMesh& surface) {
  processing::triangulate_faces(surface);
  Mesh mesh;
  std::map<SurfaceMesh::Vertex_index, Index> index;
  for (const auto vertex : surface.vertices()) {
    index[vertex] = static_cast<Index>(mesh.positions.size());
    const auto& p = surface.point(vertex);
    mesh.positions.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                CGAL::to_double(p.z()));
  }
  for (const auto face : surface.faces()) {
    Face corners{};
    std::size_t i = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      corners.at(i++) = index.at(vertex);
    }
    mesh.faces.push_back(corners);
  }
  return mesh;
}

}  // namespace

Booleans cgal_booleans(const Mesh& first, const Mesh& second) {
  SurfaceMesh a = to_cgal(first);
  SurfaceMesh b = to_cgal(second);
  std::array<SurfaceMesh, 3> out;
  std::array<boost::optional<SurfaceMesh*>, 4> wanted;
  wanted[processing::Corefinement::UNION] = out.data();
  wanted[processing::Corefinement::INTERSECTION] = &out[1];
  wanted[processing::Corefinement::TM1_MINUS_TM2] = &out[2];
  const auto done = processing::corefine_and_compute_boolean_operations(a, b, wanted);
  if (!done[processing::Corefinement::UNION] || !done[processing::Corefinement::INTERSECTION] ||
      !done[processing::Corefinement::TM1_MINUS_TM2]) {
    throw std::runtime_error("the result is not a manifold");
  }
  return {from_cgal(out[0]), from_cgal(out[1]), from_cgal(out[2])};
}

}  // namespace transformesh::test
