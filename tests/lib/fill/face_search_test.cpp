/// Faces near boxes in a growing mesh, compared with a test of all faces.
#include "fill/face_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "helpers/shapes.h"
#include "mesh/triangle.h"
#include "transformesh/measure.h"

using namespace transformesh;

namespace {

Box box_of(const Triangle& triangle) {
  Box box;
  for (const Vec3& corner : triangle) box.extend(corner);
  return box;
}

}  // namespace

TEST_CASE("every face that touches the box of a triangle is found, however faces came") {
  Mesh mesh = test::icosphere(2);
  FaceSearch search(mesh);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  const auto point = [&] {
    return Vec3(coordinate(random), coordinate(random), coordinate(random));
  };
  for (int step = 0; step < 200; ++step) {
    for (std::size_t more = random() % 9; more > 0; --more) {
      const auto first = static_cast<Index>(mesh.positions.size());
      const Vec3 middle = point();
      for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(middle + point() / 8);
      mesh.faces.push_back({first, first + 1, first + 2});
    }
    search.update();
    std::vector<Triangle> triangles(random() % 9);
    for (Triangle& triangle : triangles) triangle = {point(), point(), point()};
    const std::vector<Index> found = search.near(triangles);
    CHECK(std::ranges::is_sorted(found));
    CHECK(std::ranges::adjacent_find(found) == found.end());
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      const bool is_near = std::ranges::any_of(triangles, [&](const Triangle& triangle) {
        return box_of(triangle).intersects(box_of(triangle_of(mesh, f)));
      });
      if (is_near) CHECK(std::ranges::binary_search(found, f));
    }
  }
}
