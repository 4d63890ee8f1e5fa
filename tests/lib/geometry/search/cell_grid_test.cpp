#include "geometry/search/cell_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "helpers/random.h"
#include "helpers/shapes.h"

using namespace transformesh;

namespace {

std::set<Cell> cells_of(const CellGrid& grid, const Triangle& t, double margin = 0) {
  std::vector<Cell> cells;
  grid.find(t, margin, cells);
  return {cells.begin(), cells.end()};
}

Vec3 point_in(const Triangle& t, test::Random& random) {
  double a = random.uniform(0, 1), b = random.uniform(0, 1);
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  return t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
}

}  // namespace

TEST_CASE("every point of a triangle, and what is near it, is in one of its cells") {
  test::Random random(4);
  const CellGrid grid(.05);
  for (int i = 0; i < 100; ++i) {
    const double size = i % 3 == 0 ? .01 : 1;
    const Vec3 at = random.point(-2, 2);
    const Triangle t{at, at + size * random.point(-1, 1), at + size * random.point(-1, 1)};
    const std::set<Cell> cells = cells_of(grid, t, 1e-3);
    for (int k = 0; k < 50; ++k) {
      const Vec3 near = point_in(t, random) + 5e-4 * random.point(-1, 1);
      for (const Cell cell : cells_of(grid, {near, near, near})) {
        CHECK(cells.contains(cell));
        CHECK(grid.box_around(cell).contains(near));
        CHECK(grid.box_around(cell).sizes().maxCoeff() < .052);
      }
    }
  }
}

TEST_CASE("a long thin triangle has as many cells as its length, not its box") {
  const CellGrid grid(.01);
  const Triangle needle{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(1, 1, 1.001)};
  CHECK(cells_of(grid, needle).size() < 2000);
}

TEST_CASE("coordinates of any size have cells") {
  for (const double scale : {1e-300, 1., 1e300}) {
    CellSize size;
    const Mesh ball = test::scaled(test::icosphere(2), scale);
    for (Index f = 0; f < ball.faces.size(); ++f) size.add(triangle_of(ball, f));
    CHECK(size.size() >= size.least());
    CHECK(size.size() > .05 * scale);
    CHECK(size.size() < scale);
    std::set<Cell> all;
    for (Index f = 0; f < ball.faces.size(); ++f)
      all.merge(cells_of(CellGrid(size.size()), triangle_of(ball, f)));
    CHECK(all.size() > 20);
  }
}

TEST_CASE("one small face among large ones does not make too many cells") {
  CellSize size;
  for (int i = 0; i < 1000000; ++i) size.add({Vec3(0, 0, 0), Vec3(1e-9, 0, 0), Vec3(0, 1e-9, 0)});
  size.add({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
  CHECK(size.size() == 1. / 256);
}

TEST_CASE("marks are those made before a round, each once") {
  test::Random random(5);
  CellMarks marks;
  std::array<std::map<Cell, std::set<Index>>, 2> expected;
  for (int i = 0; i < 20000; ++i) {
    const Cell cell = random.below(3000) << 42 | random.below(3);
    const auto number = static_cast<Index>(random.below(7));
    const Index round = i < 8000 ? 0 : 1;
    marks.add(cell, number, round);
    if (round == 0) expected[0][cell].insert(number);
    expected[1][cell].insert(number);
  }
  for (Cell x = 0; x < 3000; ++x)
    for (Cell z = 0; z < 4; ++z)
      for (const Index round : {1, 2}) {
        const Cell cell = x << 42 | z;
        std::vector<Index> found;
        marks.visit(cell, round, [&](Index number) {
          found.push_back(number);
          return false;
        });
        std::sort(found.begin(), found.end());
        const std::set<Index>& all = expected[round - 1][cell];
        CHECK(found == std::vector<Index>(all.begin(), all.end()));
        CHECK(marks.has(cell) == !expected[1][cell].empty());
      }
  CHECK(!CellMarks().has(1));
}
