/// Conversion between meshes of the library and of CGAL, for benchmarks.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "helpers/cgal_mesh.h"

namespace transformesh {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

inline Mesh plain_mesh(SurfaceMesh& surface) {
  surface.collect_garbage();
  Mesh mesh;
  for (const auto vertex : surface.vertices()) {
    const auto& p = surface.point(vertex);
    mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : surface.faces()) {
    Face corners{};
    std::size_t i = 0;
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face)))
      corners[i++] = static_cast<Index>(vertex);
    mesh.faces.push_back(corners);
  }
  return mesh;
}

}  // namespace transformesh
