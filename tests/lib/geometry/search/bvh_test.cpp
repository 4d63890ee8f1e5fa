#include "geometry/search/bvh.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "helpers/random.h"
#include "helpers/shapes.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

namespace {

std::vector<Bvh::Pair> pairs_of(const Bvh& bvh) {
  std::vector<std::vector<Bvh::Pair>> lists;
  bvh.visit_pairs([&](std::size_t count) { lists.resize(count); },
                  [&](std::size_t list, std::span<const Bvh::Pair> pairs) {
                    lists[list].insert(lists[list].end(), pairs.begin(), pairs.end());
                  });
  std::vector<Bvh::Pair> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  std::sort(all.begin(), all.end());
  return all;
}

bool touch(const FloatBox& a, const FloatBox& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (a.max()[axis] < b.min()[axis] || b.max()[axis] < a.min()[axis]) return false;
  return true;
}

std::vector<Bvh::Pair> pairs_by_search(const std::vector<FloatBox>& boxes) {
  std::vector<Bvh::Pair> pairs;
  for (Index i = 0; i < boxes.size(); ++i)
    for (Index j = i + 1; j < boxes.size(); ++j)
      if (touch(boxes[i], boxes[j])) pairs.emplace_back(i, j);
  return pairs;
}

std::vector<FloatBox> random_boxes(std::uint64_t seed, std::size_t count, double size) {
  test::Random random(seed);
  std::vector<FloatBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 low = random.point(0, 1);
    boxes.push_back(float_box(low, low + random.point(0, size)));
  }
  return boxes;
}

/// Small integer coordinates: boxes that touch, coincide, or have no extent.
std::vector<FloatBox> lattice_boxes(std::uint64_t seed, std::size_t count) {
  test::Random random(seed);
  std::vector<FloatBox> boxes(count);
  for (FloatBox& box : boxes)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min()[axis] = static_cast<float>(random.below(8));
      box.max()[axis] = box.min()[axis] + static_cast<float>(random.below(3));
    }
  return boxes;
}

}  // namespace

TEST_CASE("pairs agree with a search for any number of boxes") {
  for (std::size_t count = 0; count < 40; ++count) {
    const auto boxes = lattice_boxes(count, count);
    CHECK(pairs_of(Bvh(boxes)) == pairs_by_search(boxes));
    CHECK(Bvh(boxes).empty() == (count == 0));
  }
  for (const double size : {0.0, 0.02, 0.1, 1.0}) {
    const auto boxes = random_boxes(7, 1500, size);
    CHECK(pairs_of(Bvh(boxes)) == pairs_by_search(boxes));
  }
  const auto boxes = lattice_boxes(3, 1500);
  CHECK(pairs_of(Bvh(boxes)) == pairs_by_search(boxes));
}

TEST_CASE("boxes at the ends of the float range and beyond are paired") {
  for (const double scale : {1e-320, 1e-44, 1e-30, 1e30, 1e38, 1e39, 1e300}) {
    test::Random random(11);
    std::vector<FloatBox> boxes;
    for (int i = 0; i < 300; ++i) {
      const Vec3 low = random.point(-10, 10);
      boxes.push_back(float_box(scale * low, scale * (low + random.point(0, 2))));
    }
    CHECK(pairs_of(Bvh(boxes)) == pairs_by_search(boxes));
  }
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<FloatBox> boxes = lattice_boxes(5, 50);
  boxes.emplace_back(Eigen::Vector3f::Constant(-infinity), Eigen::Vector3f::Constant(infinity));
  CHECK(pairs_of(Bvh(boxes)) == pairs_by_search(boxes));
}

TEST_CASE("boxes of one group are not paired, those of none are") {
  for (const std::size_t count : {1, 3, 50, 1000}) {
    const auto boxes = random_boxes(12, count, 0.3);
    for (const Index groups : {1, 2, 40}) {
      std::vector<Index> group_of(count);
      for (Index i = 0; i < count; ++i)
        group_of[i] = i % 5 == 0 ? no_index : boxes[i].min()[0] < 0 ? 0 : i % groups;
      std::vector<Bvh::Pair> expected;
      for (const auto& [i, j] : pairs_by_search(boxes))
        if (group_of[i] == no_index || group_of[i] != group_of[j]) expected.emplace_back(i, j);
      Bvh bvh(boxes);
      bvh.set_groups(group_of);
      CHECK(pairs_of(bvh) == expected);
    }
  }
}

TEST_CASE("many equal boxes do not make the tree deep") {
  const std::vector<FloatBox> boxes(10000, float_box(Vec3::Zero(), Vec3::Ones()));
  std::atomic<std::size_t> count = 0;
  Bvh(boxes).visit_pairs(
      [](std::size_t) {},
      [&](std::size_t, std::span<const Bvh::Pair> pairs) { count += pairs.size(); });
  CHECK(count == std::size_t{10000} * 9999 / 2);
}

TEST_CASE("pairs are the same for any number of threads") {
  const Mesh mesh = test::joined(test::icosphere(4), test::moved(test::icosphere(4), {0.3, 0, 0}));
  std::vector<std::vector<Bvh::Pair>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    results.push_back(pairs_of(Bvh(mesh)));
  }
  CHECK(results[0] == pairs_by_search(face_boxes(mesh)));
  CHECK(results[1] == results[0]);
  CHECK(results[2] == results[0]);
}

TEST_CASE("visited overlaps agree with a search and stop on request") {
  const auto boxes = random_boxes(8, 1000, 0.2);
  const Bvh bvh(boxes);
  for (const FloatBox& box : random_boxes(9, 50, 0.3)) {
    std::vector<Index> visited;
    bvh.visit_overlaps(box, [&](Index i) {
      visited.push_back(i);
      return true;
    });
    std::sort(visited.begin(), visited.end());
    std::vector<Index> expected;
    for (Index i = 0; i < boxes.size(); ++i)
      if (touch(boxes[i], box)) expected.push_back(i);
    CHECK(visited == expected);
  }
  int calls = 0;
  bvh.visit_overlaps(float_box(Vec3::Zero(), Vec3::Ones()), [&](Index) { return ++calls < 3; });
  CHECK(calls == 3);
  Bvh().visit_overlaps(boxes[0], [&](Index) { return ++calls < 0; });
  CHECK(calls == 3);
}

TEST_CASE("boxes that overlap a box of another tree are visited once") {
  for (const std::size_t count : {0, 1, 7, 300}) {
    const auto boxes = random_boxes(8, 1000, 0.2), others = random_boxes(9, count, 0.3);
    std::vector<Index> visited;
    Bvh(boxes).visit_overlaps(Bvh(others), [&](Index i) { visited.push_back(i); });
    std::sort(visited.begin(), visited.end());
    std::vector<Index> expected;
    for (Index i = 0; i < boxes.size(); ++i)
      if (std::ranges::any_of(others, [&](const FloatBox& box) { return touch(boxes[i], box); }))
        expected.push_back(i);
    CHECK(visited == expected);
  }
}
