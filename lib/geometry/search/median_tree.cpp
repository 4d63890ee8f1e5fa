#include "geometry/search/median_tree.h"

#include <algorithm>
#include <numeric>

#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t most_boxes_per_task = 8192;  ///< affects time only

void extend(FloatBox& box, const FloatBox& by) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min()[axis] = std::min(box.min()[axis], by.min()[axis]);
    box.max()[axis] = std::max(box.max()[axis], by.max()[axis]);
  }
}

/// Returns the axis with the largest extent of the centers.
template <class Center>
std::size_t widest_axis(std::span<const Center> centers) {
  std::array<float, 3> low = centers[0].position;
  std::array<float, 3> high = low;
  for (const Center& center : centers)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], center.position[axis]);
      high[axis] = std::max(high[axis], center.position[axis]);
    }
  std::size_t widest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
  return widest;
}

}  // namespace

MedianTree::Halves::Halves(const FloatBox& left, const FloatBox& right) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    minimum[axis] = {left.min()[static_cast<Eigen::Index>(axis)],
                     right.min()[static_cast<Eigen::Index>(axis)]};
    maximum[axis] = {left.max()[static_cast<Eigen::Index>(axis)],
                     right.max()[static_cast<Eigen::Index>(axis)]};
  }
}

FloatBox MedianTree::Halves::both() const {
  FloatBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min()[axis] = std::min(minimum[axis][0], minimum[axis][1]);
    box.max()[axis] = std::max(maximum[axis][0], maximum[axis][1]);
  }
  return box;
}

MedianTree::MedianTree(std::span<const FloatBox> boxes, std::size_t bucket_size, BoxOrder order)
    : bucket_size_(bucket_size), order_(boxes.size()) {
  if (boxes.empty()) return;
  std::size_t leaves = 1;
  for (std::size_t size = boxes.size(); size > bucket_size; size -= size / 2) leaves *= 2;
  nodes_.resize(leaves - 1);
  if (order == BoxOrder::of_tree) {
    std::iota(order_.begin(), order_.end(), Index{0});
    enclose(boxes, {0, boxes.size(), 0, 0});
    return;
  }
  std::vector<Center> centers(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      centers[i].position[axis] = static_cast<float>(center(boxes[i], axis));
    centers[i].box = static_cast<Index>(i);
  }
  build(boxes, centers, {0, boxes.size(), 0, 0});
}

FloatBox MedianTree::build(std::span<const FloatBox> boxes, std::vector<Center>& centers,
                           const Cell& cell) {
  const std::size_t size = cell.last - cell.first;
  const std::span<Center> own(centers.data() + cell.first, size);
  if (size <= bucket_size_) {
    FloatBox box = boxes[own[0].box];
    for (std::size_t i = 0; i < size; ++i) {
      order_[cell.first + i] = own[i].box;
      extend(box, boxes[own[i].box]);
    }
    return box;
  }

  // Split the cell at the median of its widest axis. The box of the cell is the union of the boxes
  // of both halves.
  const std::size_t axis = widest_axis(std::span<const Center>(own));
  const std::size_t child = 2 * cell.node + 1;
  std::nth_element(
      own.begin(), own.begin() + static_cast<std::ptrdiff_t>(size / 2), own.end(),
      [axis](const Center& a, const Center& b) { return a.position[axis] < b.position[axis]; });
  FloatBox left_box;
  FloatBox right_box;
  const auto left = [&] {
    left_box = build(boxes, centers, {cell.first, cell.middle(), child, 0});
  };
  const auto right = [&] {
    right_box = build(boxes, centers, {cell.middle(), cell.last, child + 1, 0});
  };
  if (size > most_boxes_per_task) {
    parallel_invoke(left, right);
  } else {
    left();
    right();
  }
  nodes_[cell.node] = Halves(left_box, right_box);
  return nodes_[cell.node].both();
}

FloatBox MedianTree::enclose(std::span<const FloatBox> boxes, const Cell& cell) {
  if (cell.last - cell.first <= bucket_size_) {
    FloatBox box = boxes[cell.first];
    for (std::size_t i = cell.first + 1; i < cell.last; ++i) extend(box, boxes[i]);
    return box;
  }
  const std::size_t child = 2 * cell.node + 1;
  const FloatBox left = enclose(boxes, {cell.first, cell.middle(), child, 0});
  const FloatBox right = enclose(boxes, {cell.middle(), cell.last, child + 1, 0});
  nodes_[cell.node] = Halves(left, right);
  return nodes_[cell.node].both();
}

}  // namespace transformesh
