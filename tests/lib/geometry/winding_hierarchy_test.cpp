#include "geometry/winding_hierarchy.h"

#include <doctest/doctest.h>

#include <random>

#include "geometry/solid_angle_winding.h"
#include "helpers/shapes.h"
#include "transformesh/measure.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

std::vector<Vec3> random_points(const Mesh& mesh, std::size_t count) {
  const Box box = bounding_box(mesh);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> share(-0.3, 1.3);
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
    for (int i = 0; i < 3; ++i) point[i] = box.min()[i] + share(random) * box.sizes()[i];
  return points;
}

Mesh without_faces(Mesh mesh, double share) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(0, 1);
  std::erase_if(mesh.faces, [&](const Face&) { return number(random) < share; });
  return mesh;
}

Mesh upper_part(Mesh mesh) {
  std::erase_if(mesh.faces, [&](const Face& face) { return mesh.positions[face[0]].z() < 0.1; });
  return mesh;
}

double largest_difference(const Mesh& mesh) {
  const WindingHierarchy hierarchy(mesh);
  const SolidAngleWinding all(mesh);
  double largest = 0;
  for (const Vec3& point : random_points(mesh, 200))
    largest = std::max(largest, std::abs(hierarchy(point) - all(point).number));
  return largest;
}

}  // namespace

TEST_CASE("a hierarchy gives the winding numbers of a sum over all faces") {
  const Mesh closed = icosphere(4);
  CHECK(largest_difference(closed) < 1e-10);
  CHECK(largest_difference(upper_part(closed)) < 1e-10);
  CHECK(largest_difference(without_faces(closed, 0.05)) < 1e-10);
  CHECK(largest_difference(without_faces(closed, 0.7)) < 1e-10);
}

TEST_CASE("a hierarchy counts faces that several sheets share as often as they occur") {
  Mesh twice = upper_part(icosphere(3));
  const std::vector<Face> faces = twice.faces;
  twice.faces.insert(twice.faces.end(), faces.begin(), faces.end());
  CHECK(largest_difference(twice) < 1e-10);
  for (Face face : faces) {
    std::swap(face[0], face[1]);
    twice.faces.push_back(face);
  }
  CHECK(largest_difference(twice) < 1e-10);
}

TEST_CASE("a hierarchy gives winding numbers of unconnected faces") {
  const Mesh connected = upper_part(icosphere(3));
  Mesh soup;
  for (const Face& face : connected.faces) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : face) soup.positions.push_back(connected.positions[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  CHECK(largest_difference(soup) < 1e-10);
}

TEST_CASE("a hierarchy gives winding numbers of very large and very small meshes") {
  for (const double scale : {1e150, 1e-150}) {
    Mesh mesh = upper_part(icosphere(3));
    for (Vec3& position : mesh.positions) position *= scale;
    CHECK(largest_difference(mesh) < 1e-10);
  }
}

TEST_CASE("a face that is left out does not count, even for points on it") {
  const Mesh mesh = icosphere(3);
  const WindingHierarchy hierarchy(mesh);
  for (Index f = 0; f < 200; ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 center = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    CHECK(hierarchy(center, std::vector<Index>{f}) == doctest::Approx(0.5).epsilon(1e-9));
  }
}

TEST_CASE("the winding number of a hierarchy without faces is 0") {
  const Mesh empty;
  CHECK(WindingHierarchy(empty)(Vec3(1, 2, 3)) == 0);
}
