#include "helpers/cgal_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <iterator>

#include "helpers/cgal_mesh.h"

namespace transformesh::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

using Pair = std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>;

std::vector<Pair> pairs_of(const Mesh& mesh) {
  const SurfaceMesh surface = surface_mesh<Kernel>(mesh);
  std::vector<Pair> pairs;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
      surface, std::back_inserter(pairs));
  return pairs;
}

}  // namespace

std::size_t count_self_intersections(const Mesh& mesh) { return pairs_of(mesh).size(); }

std::size_t count_self_intersections_apart(const Mesh& mesh) {
  const auto touch = [&](const Pair& pair) {
    for (const Index v : mesh.faces[pair.first.idx()])
      for (const Index w : mesh.faces[pair.second.idx()])
        if (v != w && mesh.positions[v] == mesh.positions[w]) return true;
    return false;
  };
  const std::vector<Pair> pairs = pairs_of(mesh);
  return pairs.size() - static_cast<std::size_t>(std::ranges::count_if(pairs, touch));
}

}  // namespace transformesh::test
