#include "geometry/search/kd_tree.h"

#include <algorithm>
#include <limits>

#include "geometry/search/median_tree_visit.h"

namespace transformesh {
namespace {

/// Largest number of points per leaf of the tree; affects time only.
constexpr std::size_t points_per_leaf = 8;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Candidate {
  double distance = infinity;  ///< squared distance of the point from the query
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

class NearestAccepted {
 public:
  NearestAccepted(double bound, const std::function<bool(Index)>& accept)
      : accept_(accept), best_{bound, no_index} {}
  double bound() const { return best_.distance; }
  void offer(const Candidate& candidate) {
    const bool is_nearer =
        best_.index == no_index ? candidate.distance < best_.distance : candidate < best_;
    if (is_nearer && accept_(candidate.index)) best_ = candidate;
  }
  Index index() const { return best_.index; }

 private:
  const std::function<bool(Index)>& accept_;
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
  std::vector<Candidate> heap_;  ///< candidates as a max-heap: the farthest one is first
};

std::vector<FloatBox> point_boxes(std::span<const Vec3> points) {
  std::vector<FloatBox> boxes;
  boxes.reserve(points.size());
  for (const Vec3& point : points) boxes.push_back(float_box(point, point));
  return boxes;
}

std::vector<Vec3> in_order(std::span<const Vec3> points, std::span<const Index> order) {
  std::vector<Vec3> result;
  result.reserve(order.size());
  for (const Index index : order) result.push_back(points[index]);
  return result;
}

}  // namespace

KdTree::KdTree(std::span<const Vec3> points)
    : tree_(point_boxes(points), points_per_leaf),
      order_(tree_.order()),
      points_(in_order(points, order_)) {}

KdTree::KdTree(std::span<const Vec3> points, std::span<const Index> order)
    : tree_(point_boxes(in_order(points, order)), points_per_leaf, BoxOrder::of_tree),
      order_(order.begin(), order.end()),
      points_(in_order(points, order)) {}

template <class Found>
void KdTree::search(const Vec3& query, Found& found) const {
  tree_.visit_nearest(
      query, [&] { return found.bound(); },
      [&](std::size_t place) {
        const Vec3 offset = points_[place] - query;
        found.offer(
            {MedianTree::squared_length(offset.x(), offset.y(), offset.z()), order_[place]});
      });
}

Index KdTree::nearest(const Vec3& query) const {
  NearestOne found;
  search(query, found);
  return found.index();
}

Index KdTree::nearest_within(const Vec3& query, double distance,
                             const std::function<bool(Index)>& accept) const {
  NearestAccepted found(distance * distance, accept);
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
