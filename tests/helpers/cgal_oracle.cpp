#include "helpers/cgal_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <iterator>

#include "helpers/cgal_mesh.h"

namespace transformesh::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

}  // namespace

std::size_t count_self_intersections(const Mesh& mesh) {
  const SurfaceMesh surface = surface_mesh<Kernel>(mesh);
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
      surface, std::back_inserter(pairs));
  return pairs.size();
}

}  // namespace transformesh::test
