/// Faces near boxes in a growing mesh, compared with a test of all faces.
#include "fill/face_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "helpers/shapes.h"
#include "mesh/triangle.h"

namespace transformesh {

TEST_CASE("every face that touches a box is found, however faces came") {
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
    const Vec3 a = point(), b = point(), low = a.cwiseMin(b), high = a.cwiseMax(b);
    std::vector<Index> found;
    search.append_near(low, high, found);
    std::sort(found.begin(), found.end());
    CHECK(std::adjacent_find(found.begin(), found.end()) == found.end());
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      const auto [p, q, r] = triangle_of(mesh.positions, mesh.faces[f]);
      const bool is_near = (p.cwiseMin(q).cwiseMin(r).array() <= high.array()).all() &&
                           (p.cwiseMax(q).cwiseMax(r).array() >= low.array()).all();
      if (is_near) CHECK(std::binary_search(found.begin(), found.end(), f));
    }
  }
}

}  // namespace transformesh
