#include "mesh/cotangent_laplacian.h"

#include <doctest/doctest.h>

#include <cmath>

#include "helpers/shapes.h"
#include "transformesh/measure.h"

using namespace transformesh;
using doctest::Approx;

namespace {

/// Energy of a function on the edges: half the sum of weight * difference^2 / 2.
double energy(const CotangentLaplacian& laplacian, const std::vector<double>& values) {
  double sum = 0;
  for (const auto& [from, to, weight] : laplacian.edges)
    sum += weight / 4 * std::pow(values[from] - values[to], 2);
  return sum;
}

std::vector<double> heights(const Mesh& mesh) {
  std::vector<double> values;
  for (const Vec3& p : mesh.positions) values.push_back(p.x());
  return values;
}

/// A plane with obtuse triangles.
Mesh sheared_plane() {
  Mesh mesh = test::grid(6);
  for (Vec3& p : mesh.positions) p.x() -= 1.5 * p.y();
  return mesh;
}

}  // namespace

TEST_CASE("bounded by triangles, the energy of a linear function is exact for obtuse angles") {
  const Mesh plane = sheared_plane();
  const std::vector<double> x = heights(plane);
  // Half the integral of the squared gradient, over an area of 1.
  CHECK(energy(cotangent_laplacian(plane, CotangentBounds::each_triangle), x) == Approx(0.5));
  CHECK(energy(cotangent_laplacian(plane, CotangentBounds::each_edge), x) > 0.6);
}

TEST_CASE("weights are bounded, and no energy is negative, also for thin triangles") {
  Mesh mesh = test::grid(6);
  for (Vec3& p : mesh.positions) p.x() -= 3000 * p.y();
  const CotangentLaplacian laplacian = cotangent_laplacian(mesh, CotangentBounds::each_triangle);
  for (const auto& edge : laplacian.edges) CHECK(std::abs(edge.weight) < 2 * 57.3);
  std::vector<double> values(mesh.positions.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    for (std::size_t u = 0; u < values.size(); ++u) values[u] = u == v || u % 3 == v % 3;
    CHECK(energy(laplacian, values) >= 0);
  }
  for (const auto& edge : cotangent_laplacian(mesh, CotangentBounds::each_edge).edges)
    CHECK(edge.weight >= 0);
}

TEST_CASE("mixed areas sum up to the area, and borders are marked") {
  const Mesh plane = sheared_plane();
  const CotangentLaplacian laplacian = cotangent_laplacian(plane, CotangentBounds::each_triangle);
  double sum = 0;
  for (const double area : laplacian.areas) sum += area;
  CHECK(sum == Approx(surface_area(plane)));
  std::size_t borders = 0;
  for (const char is_border : laplacian.is_border) borders += is_border != 0;
  CHECK(borders == 24);
}

TEST_CASE("faces without area have no weight") {
  Mesh mesh = test::grid(1);
  for (Vec3& p : mesh.positions) p = Vec3(p.x(), 0, 0);
  for (const auto& edge : cotangent_laplacian(mesh, CotangentBounds::each_triangle).edges)
    CHECK(edge.weight == 0);
}
