// Pairs of overlapping boxes, compared with a test of all pairs.
#include <doctest/doctest.h>

#include <atomic>

#include "geometry/search/bvh.h"
#include "helpers/random.h"
#include "support/parallel.h"

using namespace transformesh;

namespace {

std::vector<FloatBox> random_boxes(std::uint64_t seed, std::size_t count, double size) {
  test::Random random(seed);
  std::vector<FloatBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 low = random.point(-1, 1);
    boxes.push_back(float_box(low, low + random.point(0, size)));
  }
  return boxes;
}

/// Tests for overlap along each axis.
bool overlap(const FloatBox& a, const FloatBox& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.max()[axis] < b.min()[axis] || b.max()[axis] < a.min()[axis]) return false;
  return true;
}

bool every_pair(Index, Index) { return true; }

}  // namespace

TEST_CASE("pairs of two sets are those of all with all, from either side") {
  for (const std::size_t count : {0, 1, 3, 4, 5, 200, 1000}) {
    CAPTURE(count);
    const auto here = random_boxes(1, count, .3), there = random_boxes(2, 300, .2);
    std::vector<Bvh::Pair> expected;
    for (Index i = 0; i < here.size(); ++i)
      for (Index k = 0; k < there.size(); ++k)
        if (overlap(here[i], there[k])) expected.emplace_back(i, k);
    const Bvh first(here), second(there);
    CHECK(first.overlapping_pairs(second, every_pair) == expected);
    std::vector<Bvh::Pair> turned;
    for (const auto& [i, k] : second.overlapping_pairs(first, every_pair))
      turned.emplace_back(k, i);
    std::sort(turned.begin(), turned.end());
    CHECK(turned == expected);
  }
}

TEST_CASE("visited pairs are those that are collected, list by list") {
  const auto boxes = random_boxes(3, 2000, .15);
  const Bvh bvh(boxes);
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    std::vector<std::vector<Bvh::Pair>> lists;
    bvh.visit_pairs([&](std::size_t count) { lists.resize(count); },
                    [&](std::size_t list, std::span<const Bvh::Pair> pairs) {
                      lists[list].insert(lists[list].end(), pairs.begin(), pairs.end());
                    });
    std::vector<Bvh::Pair> all;
    for (const auto& list : lists)
      for (const auto& [i, k] : list) all.emplace_back(std::min(i, k), std::max(i, k));
    std::sort(all.begin(), all.end());
    CHECK(all == bvh.overlapping_pairs(every_pair));
  }
}

TEST_CASE("boxes of the same group are no pairs, and those of no group are") {
  auto boxes = random_boxes(4, 400, .4);
  std::vector<Index> groups;
  for (Index i = 0; i < boxes.size(); ++i) groups.push_back(i % 5 == 4 ? no_index : i % 5);
  Bvh bvh(boxes);
  bvh.set_groups(groups);
  std::vector<Bvh::Pair> expected;
  for (Index i = 0; i < boxes.size(); ++i)
    for (Index k = i + 1; k < boxes.size(); ++k)
      if (overlap(boxes[i], boxes[k]) && (groups[i] == no_index || groups[i] != groups[k]))
        expected.emplace_back(i, k);
  CHECK(bvh.overlapping_pairs(every_pair) == expected);
}

TEST_CASE("pairs that are not accepted are left out") {
  const auto boxes = random_boxes(5, 300, .5);
  const auto pairs =
      Bvh(boxes).overlapping_pairs([](Index i, Index k) { return (i + k) % 2 == 0; });
  CHECK(!pairs.empty());
  for (const auto& [i, k] : pairs) CHECK((i + k) % 2 == 0);
}
