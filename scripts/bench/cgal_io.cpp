// Reads and writes a PLY by CGAL, for comparison with tm-convert. Prints the CPU seconds.
//   cgal-io INPUT OUTPUT
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <ctime>
#include <fstream>
#include <iostream>

#include "driver.h"

namespace {

using SurfaceMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void measure(const std::string& input, const std::string& output) {
  const std::clock_t start = std::clock();
  SurfaceMesh surface;
  std::ifstream in(input, std::ios::binary);
  std::ofstream out(output, std::ios::binary);
  CGAL::IO::set_binary_mode(out);
  if (!CGAL::IO::read_PLY(in, surface) || !CGAL::IO::write_PLY(out, surface) || !out.flush())
    throw std::runtime_error("cannot read " + input + " or write " + output);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << "faces: " << surface.number_of_faces() << "\nseconds: " << seconds << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  return transformesh::drive({argv, static_cast<std::size_t>(argc)}, "cgal-io INPUT OUTPUT",
                             [](const auto& words) { measure(words[0], words[1]); });
}
