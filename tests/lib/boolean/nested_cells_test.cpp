/// Cells between nested boxes, compared with cells listed by hand.
#include "boolean/nested_cells.h"

#include <doctest/doctest.h>

#include <map>

#include "helpers/arrangement_facts.h"

using namespace transformesh;

namespace {

Mesh box(double low, double high) {
  return test::cuboid(Vec3::Constant(low), Vec3::Constant(high));
}

/// The sides of the faces of boxes after cells were joined. All faces of a box are one patch.
struct JoinedSides {
  explicit JoinedSides(const Mesh& mesh)
      : arrangement(test::arranged(mesh)),
        patches(arrangement),
        sides(join_sides_around_edges(arrangement, patches)),
        outermost(sides.find(join_nested_cells(arrangement, patches, sides))) {
    outermost = sides.find(outermost);
  }
  Index front(Index n) { return sides.find(2 * patches.patch_of[std::size_t{12} * n]); }
  Index back(Index n) { return sides.find(2 * patches.patch_of[std::size_t{12} * n] + 1); }

  Arrangement arrangement;
  Patches patches;
  DisjointSets sides;
  Index outermost;
};

}  // namespace

TEST_CASE("a body lies in the innermost cell around it") {
  // Three nested boxes, not sorted by size, and one box beside them.
  const Mesh mesh =
      test::joined(test::joined(box(2, 8), box(3, 7)), test::joined(box(0, 10), box(11, 12)));
  for (const double scale : {1.0, 1e-200, 1e300}) {
    CAPTURE(scale);
    JoinedSides joined(test::scaled(mesh, scale));
    REQUIRE(joined.patches.size() == 4);
    CHECK(joined.front(2) == joined.outermost);
    CHECK(joined.front(3) == joined.outermost);
    CHECK(joined.front(0) == joined.back(2));
    CHECK(joined.front(1) == joined.back(0));
    std::map<Index, int> cells;
    for (Index n = 0; n < 4; ++n) ++cells[joined.back(n)];
    cells[joined.outermost];
    CHECK(cells.size() == 5);
  }
}

TEST_CASE("a cavity bounds the cell inside of its shell") {
  JoinedSides joined(test::joined(test::reversed(box(2, 8)), box(0, 10)));
  CHECK(joined.back(0) == joined.back(1));
  CHECK(joined.front(0) != joined.back(1));
  CHECK(joined.front(1) == joined.outermost);
}

TEST_CASE("a body in the box of a cell, but not in the cell, is outside") {
  // The box lies in the hole of the ring.
  const Mesh ring = test::torus(3, 1, 24, 12);
  const Mesh mesh = test::joined(box(-0.5, 0.5), ring);
  JoinedSides joined(mesh);
  CHECK(joined.front(0) == joined.outermost);
  CHECK(joined.front(1) == joined.outermost);
  CHECK(joined.back(1) != joined.outermost);
}
