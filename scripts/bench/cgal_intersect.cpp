// Finds the pairs of intersecting faces of a PLY or OFF mesh by CGAL, for comparison with
// tm-intersect. Reads with the library, and prints the number of pairs and the CPU seconds of the
// search.
//
//     cgal-intersect INPUT
//
// For CGAL, faces that share a vertex index are neighbors; for tm-intersect, faces that share a
// position. The counts differ if a mesh has duplicate positions.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <ctime>
#include <iostream>
#include <iterator>

#include "driver.h"
#include "helpers/cgal_mesh.h"
#include "mesh_file.h"

using namespace transformesh;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

void measure(const std::string& path) {
  const SurfaceMesh surface = test::surface_mesh<Kernel>(read_file(path));
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  const std::clock_t start = std::clock();
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
      surface, std::back_inserter(pairs));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << "pairs: " << pairs.size() << "\nseconds: " << seconds << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return drive({argv, static_cast<std::size_t>(argc)}, "cgal-intersect INPUT",
               [](const auto& words) { measure(words[0]); });
}
