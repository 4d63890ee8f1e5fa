#include "clean/tiles/tile_boxes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "helpers/random.h"

using namespace transformesh;

namespace {

bool has(const Box& box, const Vec3& p) {
  return (p.array() >= box.min().array()).all() && (p.array() < box.max().array()).all();
}

std::vector<std::size_t> counts(const std::vector<Box>& boxes, const std::vector<Vec3>& points) {
  std::vector<std::size_t> result;
  for (const Box& box : boxes)
    result.push_back(static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](const Vec3& p) { return has(box, p); })));
  return result;
}

}  // namespace

TEST_CASE("boxes divide space, and have about equally many points") {
  test::Random random(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 7000; ++i) points.push_back(random.point(-1, 1).cwiseProduct(Vec3(9, 1, 3)));
  for (const std::size_t count : {1, 2, 3, 7, 16, 64}) {
    const std::vector<Box> boxes = divide_space(points, count);
    REQUIRE(boxes.size() == count);
    for (const std::size_t n : counts(boxes, points)) {
      CHECK(n + 2 * count >= points.size() / count);
      CHECK(n <= points.size() / count + 2 * count);
    }
    for (int i = 0; i < 200; ++i) {
      const Vec3 far = random.point(-100, 100);
      CHECK(std::count_if(boxes.begin(), boxes.end(),
                          [&](const Box& box) { return has(box, far); }) == 1);
    }
  }
}

TEST_CASE("points in one place, and no points, still give that many boxes") {
  const std::vector<Vec3> same(50, Vec3(1, 2, 3));
  for (const auto& points : {same, std::vector<Vec3>()}) {
    const std::vector<Box> boxes = divide_space(points, 5);
    REQUIRE(boxes.size() == 5);
    const auto n = counts(boxes, points);
    CHECK(*std::max_element(n.begin(), n.end()) == points.size());
  }
}

TEST_CASE("the grid finds the boxes that touch a box, as testing all of them does") {
  test::Random random(2);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Box> boxes{Box(), {Vec3(-infinity, 0, 0), Vec3(0, infinity, .5)}};
  for (int i = 0; i < 60; ++i) {
    const Vec3 low = random.point(-1.2, 1);
    boxes.push_back({low, low + random.point(0, .4)});
  }
  const BoxGrid grid({Vec3::Constant(-1), Vec3::Ones()}, boxes);
  std::vector<Index> found;
  std::size_t sum = 0;
  for (int i = 0; i < 500; ++i) {
    Vec3 low = random.point(-1.1, 1);
    const Vec3 high = low + random.point(0, i % 50 == 0 ? 2 : .1);
    if (i % 7 == 0) low = boxes[2 + static_cast<std::size_t>(i) % 60].max().cwiseMin(high);
    std::vector<Index> expected;
    for (Index b = 0; b < boxes.size(); ++b)
      if (!boxes[b].isEmpty() && !boxes[b].intersection(Box(low, high)).isEmpty())
        expected.push_back(b);
    grid.find(low, high, found);
    CHECK(found == expected);
    sum += found.size();
  }
  CHECK(sum > 100);
}
