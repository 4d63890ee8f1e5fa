#include "geometry/search/median_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "geometry/search/median_tree_visit.h"
#include "helpers/random.h"
#include "support/parallel.h"
#include "transformesh/control.h"

using namespace transformesh;

namespace {

std::vector<FloatBox> random_boxes(std::size_t count, double size, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<FloatBox> boxes(count);
  for (FloatBox& box : boxes) {
    const Vec3 low = random.point(-1, 1);
    box = float_box(low, low + random.point(0, size));
  }
  return boxes;
}

double squared_distance(const Vec3& query, const FloatBox& box) {
  Vec3 way;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = query[static_cast<Eigen::Index>(axis)];
    way[static_cast<Eigen::Index>(axis)] =
        std::max({box.min()[axis] - at, at - box.max()[axis], 0.0});
  }
  return MedianTree::squared_length(way.x(), way.y(), way.z());
}

/// The box nearest to the query, with the lowest index of equally near ones, and the number of
/// boxes visited.
struct Nearest {
  Index box = no_index;
  std::size_t visited = 0;
};

Nearest nearest(const MedianTree& tree, const std::vector<FloatBox>& boxes, const Vec3& query) {
  Nearest result;
  double best = std::numeric_limits<double>::infinity();
  tree.visit_nearest(
      query, [&] { return best; },
      [&](std::size_t place) {
        const Index box = tree.order()[place];
        const double squared = squared_distance(query, boxes[box]);
        ++result.visited;
        if (squared > best || (squared == best && box > result.box)) return;
        best = squared;
        result.box = box;
      });
  return result;
}

Index nearest_by_search(const std::vector<FloatBox>& boxes, const Vec3& query) {
  Index best = 0;
  for (Index i = 1; i < boxes.size(); ++i)
    if (squared_distance(query, boxes[i]) < squared_distance(query, boxes[best])) best = i;
  return best;
}

}  // namespace

TEST_CASE("the nearest box is that of a search over all, for buckets of any size") {
  test::Random random(3);
  for (const std::size_t count : {1, 2, 3, 7, 100, 2000}) {
    for (const std::size_t bucket_size : {1, 2, 8}) {
      CAPTURE(count);
      CAPTURE(bucket_size);
      const auto boxes = random_boxes(count, 0.2, count);
      const MedianTree tree(boxes, bucket_size);
      CHECK(std::set<Index>(tree.order().begin(), tree.order().end()).size() == count);
      for (int i = 0; i < 40; ++i) {
        const Vec3 query = random.point(-2, 2);
        CHECK(nearest(tree, boxes, query).box == nearest_by_search(boxes, query));
      }
    }
  }
}

TEST_CASE("few small boxes are visited") {
  const auto boxes = random_boxes(20000, 0.01, 1);
  const MedianTree tree(boxes, 2);
  test::Random random(4);
  std::size_t visited = 0;
  for (int i = 0; i < 200; ++i) visited += nearest(tree, boxes, random.point(-1, 1)).visited;
  CHECK(visited < 200 * 40);
}

TEST_CASE("boxes in the order of a tree make the same tree without sorting") {
  const auto boxes = random_boxes(3000, 0.1, 9);
  const MedianTree tree(boxes, 2);
  std::vector<FloatBox> ordered;
  for (const Index box : tree.order()) ordered.push_back(boxes[box]);
  const MedianTree again(ordered, 2, BoxOrder::of_tree);
  test::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 query = random.point(-2, 2);
    const Nearest first = nearest(tree, boxes, query);
    const Nearest second = nearest(again, ordered, query);
    CHECK(tree.order()[second.box] == first.box);
    CHECK(second.visited == first.visited);
  }
}

TEST_CASE("the order does not depend on the number of threads, and no boxes make no visits") {
  const auto boxes = random_boxes(40000, 0.1, 2);
  const auto alone = [&] {
    const ThreadLimit limit(1);
    return MedianTree(boxes, 2).order();
  }();
  CHECK(MedianTree(boxes, 2).order() == alone);
  CHECK(nearest(MedianTree({}, 2), {}, Vec3::Zero()).visited == 0);
}
