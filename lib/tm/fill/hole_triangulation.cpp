#include "tm/fill/hole_triangulation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace transformesh {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

constexpr double infinite = std::numeric_limits<double>::infinity();

Point point_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// The largest angle between normals of neighbors in degrees, infinite if there is no
/// triangulation; then the area.
struct Weight {
  double angle = infinite;
  double area = 0;
  bool operator<(const Weight& other) const {
    return angle != other.angle ? angle < other.angle : area < other.area;
  }
};

/// Numbers for all pairs i < k, by rows i and by columns k.
class PairTable {
 public:
  PairTable(std::size_t size, double value)
      : size_(size), rows_(size * size, value), columns_(rows_) {}
  void set(std::size_t i, std::size_t k, double value) {
    rows_[i * size_ + k] = columns_[k * size_ + i] = value;
  }
  double at(std::size_t i, std::size_t k) const { return rows_[i * size_ + k]; }
  const double* row(std::size_t i) const { return rows_.data() + i * size_; }
  const double* column(std::size_t k) const { return columns_.data() + k * size_; }

 private:
  std::size_t size_;
  std::vector<double> rows_, columns_;
};

/// The triangles of a polygon, given the third corner of that at each edge.
template <class Apex>
std::vector<HoleTriangle> triangles_below(std::size_t size, const Apex& apex) {
  std::vector<HoleTriangle> triangles;
  std::vector<std::pair<Index, Index>> waiting{{0, static_cast<Index>(size - 1)}};
  while (!waiting.empty()) {
    const auto [i, k] = waiting.back();
    waiting.pop_back();
    if (i + 1 == k) continue;
    const Index m = apex(i, k);
    triangles.push_back({i, m, k});
    waiting.emplace_back(i, m);
    waiting.emplace_back(m, k);
  }
  std::reverse(triangles.begin(), triangles.end());
  return triangles;
}

/// Fills in the best triangulations between points i and k for all pairs, near ones first.
class LeastTriangulation {
 public:
  explicit LeastTriangulation(const HoleBorder& border)
      : size_(border.points.size()),
        chords_(border.chords),
        angles_(size_, infinite),
        areas_(size_, 0),
        apex_(size_ * size_, no_index) {
    for (const Vec3& p : border.points) points_.push_back(point_of(p));
    for (const Vec3& p : border.across) across_.push_back(point_of(p));
    for (std::size_t i = 0; i + 1 < size_; ++i) angles_.set(i, i + 1, 0);
  }

  std::vector<HoleTriangle> run() {
    for (std::size_t length = 2; length < size_; ++length)
      for (std::size_t i = 0; i + length < size_; ++i)
        if (!is_chord(i, i + length)) find_best(i, i + length);
    if (size_ < 3 || angles_.at(0, size_ - 1) == infinite) return {};
    return triangles_below(size_, [&](Index i, Index k) { return apex(i, k); });
  }

 private:
  bool is_chord(std::size_t i, std::size_t k) const {
    return std::binary_search(chords_.begin(), chords_.end(), std::pair<Index, Index>(i, k));
  }
  Index apex(std::size_t i, std::size_t k) const { return apex_[i * size_ + k]; }

  double angle(std::size_t i, std::size_t k, std::size_t corner, const Point& beyond) const {
    return 180 - std::abs(CGAL::to_double(CGAL::approximate_dihedral_angle(
                     points_[i], points_[k], points_[corner], beyond)));
  }
  /// At the edge from i to k, which come in this order.
  double angle_at(std::size_t i, std::size_t k, std::size_t corner) const {
    return angle(i, k, corner, i + 1 == k ? across_[i] : points_[apex(i, k)]);
  }
  void find_best(std::size_t i, std::size_t k);
  Weight improved(std::size_t i, std::size_t m, std::size_t k, const Weight& best,
                  bool may_equal) const;

  std::size_t size_;
  const std::vector<std::pair<Index, Index>>& chords_;
  std::vector<Point> points_, across_;
  PairTable angles_, areas_;
  std::vector<Index> apex_;
};

/// The weight if the triangle i, m, k is on top, where that is better than the best, or as good if
/// that counts; else infinite. What decides is computed first.
Weight LeastTriangulation::improved(std::size_t i, std::size_t m, std::size_t k, const Weight& best,
                                    bool may_equal) const {
  Weight weight{std::max(angles_.at(i, m), angles_.at(m, k)), areas_.at(i, m) + areas_.at(m, k)};
  weight.area += CGAL::to_double(
      CGAL::approximate_sqrt(CGAL::squared_area(points_[i], points_[m], points_[k])));
  const auto is_worse = [&] { return may_equal ? best < weight : !(weight < best); };
  if (is_worse()) return {};
  weight.angle = std::max(weight.angle, angle_at(i, m, k));
  if (is_worse()) return {};
  weight.angle = std::max(weight.angle, angle_at(m, k, i));
  if (i == 0 && k == size_ - 1) weight.angle = std::max(weight.angle, angle(k, i, m, across_[k]));
  if (is_worse() || CGAL::collinear(points_[i], points_[m], points_[k])) return {};
  return weight;
}

/// Ties are broken by the lowest apex.
void LeastTriangulation::find_best(std::size_t i, std::size_t k) {
  const double *left = angles_.row(i), *right = angles_.column(k);
  Weight best;
  Index best_apex = no_index;
  const auto attempt = [&](std::size_t m) {
    const Weight weight = improved(i, m, k, best, m < best_apex);
    if (weight.angle == infinite) return;
    best = weight;
    best_apex = static_cast<Index>(m);
  };
  // Those of shorter pairs are often good, and good ones spare most of the others.
  for (const Index m : {apex(i, k - 1), apex(i + 1, k)})
    if (m != no_index && std::max(left[m], right[m]) < infinite) attempt(m);
  for (std::size_t m = i + 1; m < k; ++m) {
    const double least = std::max(left[m], right[m]);
    if (least <= best.angle && least < infinite && m != best_apex) attempt(m);
  }
  angles_.set(i, k, best.angle);
  areas_.set(i, k, best.area);
  apex_[i * size_ + k] = best_apex;
}

/// Cuts off corners, the shortest new edge first.
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
    double length;  ///< of the edge that cuts it off, squared
    Index point, before, after;
    auto operator<=>(const Corner&) const = default;
  };

  void wait(Index p) {
    const Index before = previous_[p], after = next_[p];
    const std::pair<Index, Index> edge = std::minmax({before, after});
    const Vec3 &a = border_.points[before], &b = border_.points[p], &c = border_.points[after];
    if (std::binary_search(border_.chords.begin(), border_.chords.end(), edge) ||
        CGAL::collinear(point_of(a), point_of(b), point_of(c)))
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
  std::map<std::pair<Index, Index>, Index> apex_;  ///< of the triangle at an edge
};

}  // namespace

std::vector<HoleTriangle> least_triangulation(const HoleBorder& border) {
  return LeastTriangulation(border).run();
}

std::vector<HoleTriangle> greedy_triangulation(const HoleBorder& border) {
  return GreedyTriangulation(border).run();
}

}  // namespace transformesh
