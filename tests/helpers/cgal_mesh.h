/// Converts meshes to CGAL::Surface_mesh, for benchmarks and for tests that compare results with
/// those of CGAL.
#pragma once

#include <CGAL/Surface_mesh.h>

#include <stdexcept>

#include "transformesh/mesh.h"

namespace transformesh::test {

/// Returns the mesh as CGAL::Surface_mesh. Throws if it is not an oriented manifold.
template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> surface_mesh(const Mesh& mesh) {
  using SurfaceMesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Vertex = typename SurfaceMesh::Vertex_index;
  SurfaceMesh surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : mesh.faces) {
    if (surface.add_face(Vertex(a), Vertex(b), Vertex(c)) == SurfaceMesh::null_face())
      throw std::invalid_argument("the mesh is not an oriented manifold");
  }
  return surface;
}

}  // namespace transformesh::test
