// Pairs of overlapping boxes, compared with a test of all pairs.
#include <doctest/doctest.h>

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

}  // namespace

TEST_CASE("the lists of visited pairs have each overlap once, the smaller index first") {
  const auto boxes = random_boxes(3, 2000, .15);
  std::vector<Bvh::Pair> expected;
  for (Index i = 0; i < boxes.size(); ++i)
    for (Index k = i + 1; k < boxes.size(); ++k)
      if (overlap(boxes[i], boxes[k])) expected.emplace_back(i, k);
  const Bvh bvh(boxes);
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    std::vector<std::vector<Bvh::Pair>> lists;
    bvh.visit_pairs([&](std::size_t count) { lists.resize(count); },
                    [&](std::size_t list, std::span<const Bvh::Pair> pairs) {
                      lists[list].insert(lists[list].end(), pairs.begin(), pairs.end());
                    });
    std::vector<Bvh::Pair> all;
    for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
    std::sort(all.begin(), all.end());
    CHECK(all == expected);
  }
}
