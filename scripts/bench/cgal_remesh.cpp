// Isotropic remeshing by CGAL, for comparison with tm-remesh. Reads and writes with the library,
// and prints the CPU seconds of remeshing.
//   cgal-remesh EDGE ITERATIONS INPUT OUTPUT
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <ctime>
#include <iostream>

#include "cgal_surface.h"
#include "driver.h"
#include "mesh_file.h"

using namespace transformesh;

namespace {

void measure(double edge, unsigned iterations, const std::string& input,
             const std::string& output) {
  namespace parameters = CGAL::Polygon_mesh_processing::parameters;
  SurfaceMesh surface = test::surface_mesh<Kernel>(read_file(input));
  const std::clock_t start = std::clock();
  CGAL::Polygon_mesh_processing::isotropic_remeshing(surface.faces(), edge, surface,
                                                     parameters::number_of_iterations(iterations));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  write_file(output, plain_mesh(surface));
  std::cout << "seconds: " << seconds << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return drive({argv, static_cast<std::size_t>(argc)}, "cgal-remesh EDGE ITERATIONS INPUT OUTPUT",
               [](const auto& words) {
                 measure(std::stod(words[0]), static_cast<unsigned>(std::stoul(words[1])), words[2],
                         words[3]);
               });
}
