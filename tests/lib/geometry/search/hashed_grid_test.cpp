#include "geometry/search/hashed_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"

using namespace transformesh;

TEST_CASE("a grid finds near points, by brute force, also around 0 and far out") {
  for (const double far : {0.0, 1e12}) {
    Random random(7);
    const auto place = [&] {
      return Vec3(far + random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
    };
    HashedGrid grid(1);
    std::vector<Vec3> points{Vec3(far, 0, 0), Vec3(far, -0.0, -0.5)};
    while (points.size() < 300) points.push_back(place());
    for (std::size_t i = 0; i < points.size(); ++i) grid.add(points[i], static_cast<Index>(i));
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = i == 0 ? Vec3(far, -0.0, 0) : place();
      std::vector<int> visits(points.size(), 0);
      const bool ends = grid.find_around(p, [&](Index other) { return ++visits[other] > 1; });
      CHECK(!ends);  // no entry is visited twice
      bool finds_all = true;
      for (std::size_t k = 0; k < points.size(); ++k)
        if ((points[k] - p).cwiseAbs().maxCoeff() <= 1 && visits[k] != 1) finds_all = false;
      CHECK(finds_all);
      CHECK(grid.find_around(p, [](Index) { return true; }) ==
            (std::ranges::find(visits, 1) != visits.end()));
    }
  }
}
