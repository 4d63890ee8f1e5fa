#include "tm/geometry/median_tree.h"

#include <algorithm>
#include <numeric>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t boxes_per_task = 8192;

void extend(FloatBox& box, const FloatBox& by) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.minimum[axis] = std::min(box.minimum[axis], by.minimum[axis]);
    box.maximum[axis] = std::max(box.maximum[axis], by.maximum[axis]);
  }
}

/// The axis along which the centres spread most.
template <class Centre>
std::size_t widest_axis(std::span<const Centre> centres) {
  std::array<float, 3> low = centres[0].position;
  std::array<float, 3> high = low;
  for (const Centre& centre : centres)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], centre.position[axis]);
      high[axis] = std::max(high[axis], centre.position[axis]);
    }
  std::size_t widest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
  return widest;
}

}  // namespace

MedianTree::MedianTree(std::span<const FloatBox> boxes, std::size_t bucket_size, BoxOrder order)
    : bucket_size_(bucket_size), order_(boxes.size()) {
  if (boxes.empty()) return;
  std::size_t leaves = 1;
  for (std::size_t size = boxes.size(); size > bucket_size; size -= size / 2) leaves *= 2;
  nodes_.resize(2 * leaves - 1);
  if (order == BoxOrder::of_tree) {
    std::iota(order_.begin(), order_.end(), Index{0});
    enclose(boxes, {0, boxes.size(), 0, 0});
    return;
  }
  std::vector<Centre> centres(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      centres[i].position[axis] = static_cast<float>(centre(boxes[i], axis));
    centres[i].box = static_cast<Index>(i);
  }
  build(boxes, centres, {0, boxes.size(), 0, 0});
}

void MedianTree::build(std::span<const FloatBox> boxes, std::vector<Centre>& centres,
                       const Cell& cell) {
  const std::size_t size = cell.last - cell.first;
  const std::span<Centre> own(centres.data() + cell.first, size);
  FloatBox& box = nodes_[cell.node];
  if (size <= bucket_size_) {
    box = boxes[own[0].box];
    for (std::size_t i = 0; i < size; ++i) {
      order_[cell.first + i] = own[i].box;
      extend(box, boxes[own[i].box]);
    }
    return;
  }

  // Cut at the median of the widest axis; the box of the whole follows from the halves.
  const std::size_t axis = widest_axis(std::span<const Centre>(own));
  const std::size_t child = 2 * cell.node + 1;
  std::nth_element(
      own.begin(), own.begin() + static_cast<std::ptrdiff_t>(size / 2), own.end(),
      [axis](const Centre& a, const Centre& b) { return a.position[axis] < b.position[axis]; });
  const auto left = [&] { build(boxes, centres, {cell.first, cell.middle(), child, 0}); };
  const auto right = [&] { build(boxes, centres, {cell.middle(), cell.last, child + 1, 0}); };
  if (size > boxes_per_task) {
    parallel_invoke(left, right);
  } else {
    left();
    right();
  }
  box = nodes_[child];
  extend(box, nodes_[child + 1]);
}

void MedianTree::enclose(std::span<const FloatBox> boxes, const Cell& cell) {
  FloatBox& box = nodes_[cell.node];
  if (cell.last - cell.first <= bucket_size_) {
    box = boxes[cell.first];
    for (std::size_t i = cell.first + 1; i < cell.last; ++i) extend(box, boxes[i]);
    return;
  }
  const std::size_t child = 2 * cell.node + 1;
  enclose(boxes, {cell.first, cell.middle(), child, 0});
  enclose(boxes, {cell.middle(), cell.last, child + 1, 0});
  box = nodes_[child];
  extend(box, nodes_[child + 1]);
}

}  // namespace transformesh
