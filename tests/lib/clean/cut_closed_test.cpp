#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"
#include "transformesh/select.h"

using namespace transformesh;
using doctest::Approx;

TEST_CASE("a capped cut has no slivers where the plane touches a body or contains a face") {
  // The plane touches the small box from either side, and cuts the large one.
  const Mesh boxes =
      test::joined(test::cuboid({0, 0, 0}, {1, 1, 1}), test::cuboid({5, -40, -40}, {6, 40, 40}));
  for (const Vec3& normal : {Vec3(-3, 3, 3), Vec3(1, 2, 3), Vec3(3, -1, 2), Vec3(-2, -3, 1),
                             Vec3(1, 1, 0), Vec3(0, 2, 3), Vec3(1, -3, -3), Vec3(0, 0, 7)}) {
    for (const double side : {1.0, -1.0}) {
      Mesh part = boxes;
      cut_closed(part, {side * normal, side * normal.cwiseMax(0).sum()});
      CHECK(check_manifold(part).is_closed());
      double shortest = 1;
      for (const auto& [a, b, c] : part.faces)
        shortest = std::min(shortest, (part.positions[a] - part.positions[b]).norm());
      CHECK(shortest > 0.01);
    }
  }
}
