#include "helpers/cgal_boolean.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <map>
#include <stdexcept>

#include "helpers/cgal_mesh.h"
#include "helpers/cgal_versions.h"

namespace transformesh::test {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

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
  SurfaceMesh a = surface_mesh<Kernel>(first);
  SurfaceMesh b = surface_mesh<Kernel>(second);
  std::array<SurfaceMesh, 3> out;
  std::array<CgalOptional<SurfaceMesh*>, 4> wanted;
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
