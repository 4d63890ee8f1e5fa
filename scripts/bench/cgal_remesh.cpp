// Isotropic remeshing by CGAL, for comparison with tm-remesh: reads and writes through the library,
// prints the CPU seconds that remeshing took.
//   cgal-remesh EDGE ITERATIONS INPUT OUTPUT
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>

#include "tm/io/mesh_io.h"
#include "tm/support/error.h"

using namespace transformesh;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

Mesh read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("cannot open " + path);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  return read_mesh(bytes, path).document.mesh;
}

SurfaceMesh surface_mesh(const Mesh& mesh) {
  SurfaceMesh surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : mesh.faces) {
    const auto face = surface.add_face(SurfaceMesh::Vertex_index(a), SurfaceMesh::Vertex_index(b),
                                       SurfaceMesh::Vertex_index(c));
    if (face == SurfaceMesh::null_face()) throw InputError("the mesh is not an oriented manifold");
  }
  return surface;
}

Mesh plain_mesh(SurfaceMesh& surface) {
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

void measure(double edge, unsigned iterations, const std::string& input,
             const std::string& output) {
  namespace parameters = CGAL::Polygon_mesh_processing::parameters;
  SurfaceMesh surface = surface_mesh(read_file(input));
  const std::clock_t start = std::clock();
  CGAL::Polygon_mesh_processing::isotropic_remeshing(surface.faces(), edge, surface,
                                                     parameters::number_of_iterations(iterations));
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  Document document;
  document.mesh = plain_mesh(surface);
  std::ofstream(output, std::ios::binary) << write_mesh(document).bytes;
  std::cout << "seconds: " << seconds << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: cgal-remesh EDGE ITERATIONS INPUT OUTPUT\n";
    return 2;
  }
  try {
    measure(std::stod(argv[1]), static_cast<unsigned>(std::stoul(argv[2])), argv[3], argv[4]);
  } catch (const std::exception& error) {
    std::cerr << "cgal-remesh: " << error.what() << '\n';
    return 3;
  }
}
