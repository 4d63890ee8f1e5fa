#include "clean/stitch/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>

#include "geometry/numbers/predicates.h"
#include "geometry/search/kd_tree.h"
#include "mesh/disjoint_sets.h"

namespace transformesh {
namespace {

/// Limit on the average number of points whose x coordinate differs from that of a point by at most
/// the tolerance. If it is exceeded, points are joined by a grid of cells instead of a sweep along
/// x. Affects time only.
constexpr std::size_t usual_window = 100;
/// If two grid cells have at most this many pairs of points, all pairs are tested without a search
/// tree. Affects time only.
constexpr std::size_t most_tried = 4096;
/// Cells are used only if all coordinates are below this multiple of the tolerance, so that cell
/// indices are exact in doubles.
constexpr double largest_cell = 0x1p45;
/// Factor that exceeds 1 plus the relative rounding error of a distance.
constexpr double surely = 1 + 1e-9;

bool is_within(const Vec3& a, const Vec3& b, double tolerance) {
  return (b - a).stableNorm() <= tolerance;
}

// Joins points within the tolerance of each other by a sweep along x. `order` has the points sorted
// by x. Only points whose x coordinates differ by at most the tolerance are tested.
void join_by_sweep(const std::vector<Vec3>& positions, const std::vector<Index>& order,
                   double tolerance, DisjointSets& sets) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      if (positions[order[k]][0] - positions[order[i]][0] > tolerance) break;
      if (is_within(positions[order[i]], positions[order[k]], tolerance))
        sets.join(order[i], order[k]);
    }
  }
}

bool has_usual_windows(const std::vector<Vec3>& positions, const std::vector<Index>& order,
                       double tolerance) {
  std::size_t pairs = 0;
  for (std::size_t first = 0, last = 0; last < order.size(); ++last) {
    while (positions[order[last]][0] - positions[order[first]][0] > tolerance) ++first;
    pairs += last - first;
  }
  return pairs <= usual_window * order.size();
}

// Joins points that form dense clusters, by a grid of cells whose width is half the tolerance. All
// points in a cell are joined. Two cells that are at most three cells apart along each axis are
// compared. Their points are joined if a point of one cell is within the tolerance of a point of
// the other.
class HeapWeld {
 public:
  HeapWeld(const std::vector<Vec3>& positions, double tolerance)
      : positions_(positions), tolerance_(tolerance) {}

  void join(const std::vector<Index>& points, DisjointSets& sets) {
    const double width = tolerance_ / 2;
    for (const Index p : points) {
      const Vec3 place = (positions_[p] / width).array().floor();
      cells_[{place[0], place[1], place[2]}].points.push_back(p);
    }
    for (const auto& [key, cell] : cells_)
      for (const Index p : cell.points) sets.join(cell.points.front(), p);
    for (auto cell = cells_.begin(); cell != cells_.end(); ++cell) join_around(cell, sets);
  }

 private:
  using Key = std::array<double, 3>;
  struct Cell {
    std::vector<Index> points;
    std::unique_ptr<KdTree> tree;  ///< search tree of the points in the cell, built on demand
  };
  using Place = std::map<Key, Cell>::iterator;

  void join_around(Place cell, DisjointSets& sets) {
    // Points within the tolerance are at most two cells apart, because a cell is half as wide as
    // the tolerance. One more cell allows for rounding.
    constexpr int reach = 3;
    const Key key = cell->first;
    for (int i = 0; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        const Key last{key[0] + i, key[1] + j, key[2] + reach};
        auto other = cells_.lower_bound({key[0] + i, key[1] + j, key[2] - reach});
        for (; other != cells_.end() && other->first <= last; ++other) {
          const Index a = cell->second.points.front();
          const Index b = other->second.points.front();
          if (sets.find(a) != sets.find(b) && are_near(cell->second, other->second))
            sets.join(a, b);
        }
      }
    }
  }

  bool has_near(const Cell& cell, const Vec3& place) const {
    return std::any_of(cell.points.begin(), cell.points.end(),
                       [&](Index p) { return is_within(positions_[p], place, tolerance_); });
  }

  bool are_near(Cell& first, Cell& second) {
    Cell& small = first.points.size() < second.points.size() ? first : second;
    Cell& large = &small == &first ? second : first;
    const bool needs_tree = small.points.size() * large.points.size() > most_tried;
    if (needs_tree && !large.tree) {
      std::vector<Vec3> places;
      for (const Index p : large.points) places.push_back(positions_[p]);
      large.tree = std::make_unique<KdTree>(places);
    }
    return std::any_of(small.points.begin(), small.points.end(), [&](Index p) {
      const Vec3& place = positions_[p];
      if (!needs_tree) return has_near(large, place);
      const Vec3& nearest = positions_[large.points[large.tree->nearest(place)]];
      if (is_within(nearest, place, tolerance_)) return true;
      return is_within(nearest, place, tolerance_ * surely) && has_near(large, place);
    });
  }

  const std::vector<Vec3>& positions_;
  double tolerance_;
  std::map<Key, Cell> cells_;
};

// Joins vertices with equal positions, which are adjacent in `order`, and keeps only one of them in
// `order`.
void join_equal(const std::vector<Vec3>& positions, std::vector<Index>& order, DisjointSets& sets) {
  const auto is_joined = [&](Index a, Index b) {
    const bool is_equal = positions[a] == positions[b];
    if (is_equal) sets.join(a, b);
    return is_equal;
  };
  order.erase(std::unique(order.begin(), order.end(), is_joined), order.end());
}

double largest_coordinate(const std::vector<Vec3>& positions) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, p.lpNorm<Eigen::Infinity>());
  return largest;
}

}  // namespace

std::vector<Index> weld_positions(const std::vector<Vec3>& positions, double tolerance) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const int sign = compare_positions(positions[a], positions[b]);
    return sign != 0 ? sign < 0 : a < b;
  });

  DisjointSets sets(positions.size());
  join_equal(positions, order, sets);
  const bool has_cells = tolerance > 0 && largest_coordinate(positions) < largest_cell * tolerance;
  if (has_cells && !has_usual_windows(positions, order, tolerance)) {
    HeapWeld(positions, tolerance).join(order, sets);
  } else if (tolerance > 0) {
    join_by_sweep(positions, order, tolerance, sets);
  }
  std::vector<Index> representative(positions.size());
  for (Index i = 0; i < representative.size(); ++i) representative[i] = sets.find(i);
  return representative;
}

}  // namespace transformesh
