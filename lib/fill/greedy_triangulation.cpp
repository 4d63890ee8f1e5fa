#include <algorithm>
#include <map>
#include <set>

#include "fill/hole_triangulation.h"
#include "fill/hole_weights.h"
#include "geometry/numbers/predicates.h"

namespace transformesh {
namespace {

/// Triangulates a polygon by cutting off corners. The next corner is always the one whose new edge
/// is shortest.
class GreedyTriangulation {
 public:
  explicit GreedyTriangulation(const HoleBorder& border) : border_(border) {
    const auto size = static_cast<Index>(border.points.size());
    for (Index p = 0; p < size; ++p) {
      next_.push_back((p + 1) % size);
      previous_.push_back((p + size - 1) % size);
    }
    for (Index p = 0; p < size; ++p) wait(p);
  }

  std::vector<HoleTriangle> run() {
    const std::size_t size = next_.size();
    while (!waiting_.empty() && apex_.size() + 2 < size) {
      const Corner corner = *waiting_.begin();
      waiting_.erase(waiting_.begin());
      if (corner.before == previous_[corner.point] && corner.after == next_[corner.point])
        cut(corner);
    }
    if (size < 3 || apex_.size() + 2 < size) return {};
    return triangles_below(size, [&](Index i, Index k) { return apex_.at({i, k}); });
  }

 private:
  struct Corner {
    double length;  ///< squared length of the edge that cuts off the corner
    Index point, before, after;
    auto operator<=>(const Corner&) const = default;
  };

  void wait(Index p) {
    const Index before = previous_[p], after = next_[p];
    const std::pair<Index, Index> edge = std::minmax({before, after});
    const Vec3 &a = border_.points[before], &b = border_.points[p], &c = border_.points[after];
    if (std::binary_search(border_.chords.begin(), border_.chords.end(), edge) ||
        collinear(a, b, c))
      return;
    waiting_.insert({(c - a).squaredNorm(), p, before, after});
  }

  void cut(const Corner& corner) {
    HoleTriangle triangle{corner.before, corner.point, corner.after};
    std::sort(triangle.begin(), triangle.end());
    apex_[{triangle[0], triangle[2]}] = triangle[1];
    next_[corner.before] = corner.after;
    previous_[corner.after] = corner.before;
    next_[corner.point] = previous_[corner.point] = no_index;
    wait(corner.before);
    wait(corner.after);
  }

  const HoleBorder& border_;
  std::vector<Index> next_, previous_;
  std::set<Corner> waiting_;
  /// Maps the edge between the first and the last corner of each triangle to the middle corner.
  std::map<std::pair<Index, Index>, Index> apex_;
};

}  // namespace

std::vector<HoleTriangle> greedy_triangulation(const HoleBorder& border) {
  return GreedyTriangulation(border).run();
}

}  // namespace transformesh
