#include "tm/geometry/kd_tree.h"

#include <algorithm>
#include <limits>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t bucket_size = 8;          ///< cells of so few points are not cut
constexpr std::size_t points_per_task = 16384;  ///< larger cells are built in parallel

/// More than the depth of any tree, as every cut halves.
constexpr std::size_t stack_size = 64;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A cell that waits for its visit.
struct Cell {
  std::size_t first;
  std::size_t last;
  std::size_t node;
  double distance;  ///< squared, of its box
};

/// Every distance is computed by these operations in this order: rounding is monotone, so that a
/// box never seems farther than a point inside it.
double squared_length(double x, double y, double z) { return x * x + y * y + z * z; }

double squared_distance(const FloatBox& box, const Vec3& query) {
  const auto outside = [&](int axis) {
    const auto a = static_cast<std::size_t>(axis);
    return std::max({box.minimum[a] - query[axis], query[axis] - box.maximum[a], 0.0});
  };
  return squared_length(outside(0), outside(1), outside(2));
}

struct Candidate {
  double distance = infinity;  ///< squared
  Index index = no_index;
  bool operator<(const Candidate& other) const {
    return distance != other.distance ? distance < other.distance : index < other.index;
  }
};

class NearestOne {
 public:
  double bound() const { return best_.distance; }
  void offer(const Candidate& candidate) {
    if (candidate < best_) best_ = candidate;
  }
  Index index() const { return best_.index; }

 private:
  Candidate best_;
};

class NearestMany {
 public:
  explicit NearestMany(std::size_t count) : count_(count) { heap_.reserve(count); }
  double bound() const { return heap_.size() < count_ ? infinity : heap_.front().distance; }
  void offer(const Candidate& candidate) {
    if (heap_.size() == count_) {
      if (!(candidate < heap_.front())) return;
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
    heap_.push_back(candidate);
    std::push_heap(heap_.begin(), heap_.end());
  }
  std::vector<Index> indices() {
    std::sort_heap(heap_.begin(), heap_.end());
    std::vector<Index> result;
    for (const Candidate& candidate : heap_) result.push_back(candidate.index);
    return result;
  }

 private:
  std::size_t count_;
  std::vector<Candidate> heap_;  ///< the farthest in front
};

}  // namespace

KdTree::KdTree(std::span<const Vec3> points) : points_(points.size()) {
  for (std::size_t i = 0; i < points.size(); ++i)
    points_[i] = {{points[i].x(), points[i].y(), points[i].z()}, static_cast<Index>(i)};
  if (points.empty()) return;
  std::size_t leaves = 1;
  for (std::size_t size = points.size(); size > bucket_size; size -= size / 2) leaves *= 2;
  boxes_.resize(2 * leaves - 1);
  build(0, points_.size(), 0);
}

void KdTree::build(std::size_t first, std::size_t last, std::size_t node) {
  const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = points_.begin() + static_cast<std::ptrdiff_t>(last);
  Vec3 low(begin->position.data());
  Vec3 high = low;
  for (auto point = begin; point != end; ++point) {
    const Eigen::Map<const Vec3> position(point->position.data());
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  boxes_[node] = float_box(low, high);
  if (last - first <= bucket_size) return;

  // Cut at the median of the axis along which the points spread most.
  std::size_t axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = first + (last - first) / 2;
  std::nth_element(
      begin, points_.begin() + static_cast<std::ptrdiff_t>(middle), end,
      [axis](const Point& a, const Point& b) { return a.position[axis] < b.position[axis]; });
  const auto build_left = [&] { build(first, middle, 2 * node + 1); };
  const auto build_right = [&] { build(middle, last, 2 * node + 2); };
  if (last - first > points_per_task) return parallel_invoke(build_left, build_right);
  build_left();
  build_right();
}

template <class Found>
void KdTree::search(const Vec3& query, Found& found) const {
  if (points_.empty()) return;
  std::array<Cell, stack_size> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, points_.size(), 0, 0};
  while (waiting > 0) {
    // Down the nearer half of each cell; the other half waits.
    Cell cell = stack[--waiting];
    while (cell.distance <= found.bound() && cell.last - cell.first > bucket_size) {
      const std::size_t middle = cell.first + (cell.last - cell.first) / 2;
      const std::size_t child = 2 * cell.node + 1;
      const Cell left{cell.first, middle, child, squared_distance(boxes_[child], query)};
      const Cell right{middle, cell.last, child + 1, squared_distance(boxes_[child + 1], query)};
      const bool is_left_nearer = left.distance <= right.distance;
      stack[waiting] = is_left_nearer ? right : left;
      if (stack[waiting].distance <= found.bound()) ++waiting;
      cell = is_left_nearer ? left : right;
    }
    if (!(cell.distance <= found.bound())) continue;

    for (std::size_t i = cell.first; i < cell.last; ++i) {
      const auto& position = points_[i].position;
      found.offer(
          {squared_length(position[0] - query[0], position[1] - query[1], position[2] - query[2]),
           points_[i].index});
    }
  }
}

Index KdTree::nearest(const Vec3& query) const {
  NearestOne found;
  search(query, found);
  return found.index();
}

std::vector<Index> KdTree::nearest(const Vec3& query, std::size_t count) const {
  if (count == 0) return {};
  NearestMany found(std::min(count, points_.size()));
  search(query, found);
  return found.indices();
}

}  // namespace transformesh
