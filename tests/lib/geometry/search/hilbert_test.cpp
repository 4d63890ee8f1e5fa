#include "geometry/search/hilbert.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "helpers/random.h"

using namespace transformesh;

namespace {

FloatBox box_at(float x, float y, float z) { return FloatBox(Eigen::Vector3f(x, y, z)); }

bool is_permutation_of_indices(std::vector<Index> order) {
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] != i) return false;
  return true;
}

}  // namespace

TEST_CASE("the curve passes every cell once and never jumps") {
  constexpr std::uint32_t side = 16;
  std::vector<std::pair<std::uint64_t, std::array<std::uint32_t, 3>>> cells;
  for (std::uint32_t x = 0; x < side; ++x)
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t z = 0; z < side; ++z)
        cells.push_back({hilbert_index({x, y, z}), {x, y, z}});
  std::sort(cells.begin(), cells.end());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    CHECK(cells[i].first == i);
    if (i == 0) continue;
    int steps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      steps += std::abs(static_cast<int>(cells[i].second[axis]) -
                        static_cast<int>(cells[i - 1].second[axis]));
    CHECK(steps == 1);
  }
}

TEST_CASE("boxes come in the order of their centers along the curve") {
  // Two boxes at opposite corners of the range of cells give every center with integer coordinates
  // exactly the cell of these coordinates.
  constexpr float last = (1U << hilbert_bits) - 1;
  test::Random random(2);
  std::vector<FloatBox> boxes{box_at(0, 0, 0), box_at(last, last, last)};
  std::vector<std::pair<std::uint64_t, Index>> expected;
  for (int i = 0; i < 3000; ++i) {
    const auto coordinate = [&] { return static_cast<float>(random.below(1U << hilbert_bits)); };
    const float x = coordinate();
    const float y = coordinate();
    boxes.push_back(box_at(x, y, i % 2 == 0 ? coordinate() : 0));
  }
  boxes.push_back(boxes[5]);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::array<std::uint32_t, 3> cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::uint32_t>(boxes[i].min()[axis]);
    expected.emplace_back(hilbert_index(cell), static_cast<Index>(i));
  }
  std::sort(expected.begin(), expected.end());
  const auto order = hilbert_order(boxes);
  REQUIRE(order.size() == expected.size());
  for (std::size_t i = 0; i < order.size(); ++i) CHECK(order[i] == expected[i].second);
}

TEST_CASE("odd boxes are ordered too: none, one place, extremes of the range") {
  CHECK(hilbert_order(std::vector<FloatBox>()).empty());
  CHECK(hilbert_order(std::vector<Vec3>()).empty());
  const std::vector<FloatBox> same(1000, box_at(3, 4, 5));
  const auto order = hilbert_order(same);
  CHECK(std::is_sorted(order.begin(), order.end()));
  CHECK(order.size() == 1000);

  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float tiny = std::numeric_limits<float>::denorm_min();
  CHECK(is_permutation_of_indices(hilbert_order(std::vector{
      box_at(-infinity, 0, 1), box_at(infinity, infinity, 3),
      FloatBox(Eigen::Vector3f::Constant(-infinity), Eigen::Vector3f::Constant(infinity))})));
  CHECK(is_permutation_of_indices(
      hilbert_order(std::vector{box_at(0, 0, 0), box_at(tiny, 0, 0), box_at(0, 2 * tiny, tiny)})));
}

TEST_CASE("points are ordered as their boxes are") {
  std::vector<Vec3> points;
  std::vector<FloatBox> boxes;
  for (int i = 0; i < 5000; ++i) {
    points.emplace_back(i * 37 % 101, i * 53 % 97, i * 71 % 89);
    boxes.push_back(float_box(points.back(), points.back()));
  }
  CHECK(hilbert_order(points) == hilbert_order(boxes));
}
