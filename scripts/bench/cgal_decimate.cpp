// Decimation by CGAL, for comparison with tm-remesh --faces. It reads and writes through the
// library, and prints the CPU seconds that decimation took.
//
//   cgal-decimate gh|lt FACES INPUT OUTPUT      Garland & Heckbert or Lindstrom & Turk
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <ctime>
#include <iostream>

#include "cgal_surface.h"
#include "driver.h"
#include "mesh_file.h"

using namespace transformesh;
namespace simplification = CGAL::Surface_mesh_simplification;

namespace {

void decimate_by_quadrics(SurfaceMesh& surface, std::size_t edges) {
  using Policies = simplification::GarlandHeckbert_plane_policies<SurfaceMesh, Kernel>;
  const Policies policies(surface);
  const simplification::Bounded_normal_change_placement placement(policies.get_placement());
  simplification::edge_collapse(
      surface, simplification::Count_stop_predicate<SurfaceMesh>(edges),
      CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
}

void measure(const std::string& method, std::size_t faces, const std::string& input,
             const std::string& output) {
  SurfaceMesh surface = test::surface_mesh<Kernel>(read_file(input));
  // A closed surface has three edges per two faces.
  const std::size_t edges = faces * 3 / 2;
  const std::clock_t start = std::clock();
  if (method == "gh")
    decimate_by_quadrics(surface, edges);
  else
    simplification::edge_collapse(surface,
                                  simplification::Count_stop_predicate<SurfaceMesh>(edges));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  write_file(output, plain_mesh(surface));
  std::cout << "seconds: " << seconds << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return drive(
      {argv, static_cast<std::size_t>(argc)}, "cgal-decimate METHOD FACES INPUT OUTPUT",
      [](const auto& words) { measure(words[0], std::stoul(words[1]), words[2], words[3]); });
}
