#include "fill/hole_triangulation.h"

#include <algorithm>

#include "fill/hole_weights.h"
#include "geometry/search/kd_tree.h"

namespace transformesh {
namespace {

/// Number of nearest points to which edges from each point are tried in sparse_triangulation(). A
/// choice: more edges give better triangulations and take more time.
constexpr std::size_t nearest_tried = 24;

bool is_chord(const HoleBorder& border, std::size_t i, std::size_t k) {
  return std::binary_search(border.chords.begin(), border.chords.end(),
                            std::pair<Index, Index>(i, k));
}

/// Finds the best triangulation of a polygon by dynamic programming. For each pair i < k, in order
/// of k - i, the best triangulation of the subpolygon with the points i, i + 1, ..., k is computed.
class LeastTriangulation {
 public:
  explicit LeastTriangulation(const HoleBorder& border)
      : border_(border),
        weigher_(border),
        size_(border.points.size()),
        subpolygons_(size_ * size_),
        angles_(size_ * size_, HoleWeight().angle),
        angles_before_(angles_) {
    for (std::size_t i = 0; i + 1 < size_; ++i) set(i, i + 1, {{0, 0}, no_index});
  }

  std::vector<HoleTriangle> run() {
    for (std::size_t length = 2; length < size_; ++length)
      for (std::size_t i = 0; i + length < size_; ++i)
        if (!is_chord(border_, i, i + length)) set(i, i + length, best_between(i, i + length));
    if (size_ < 3 || !subpolygon(0, size_ - 1).weight.is_there()) return {};
    return triangles_below(size_, [&](Index i, Index k) { return subpolygon(i, k).apex; });
  }

 private:
  const HoleSubpolygon& subpolygon(std::size_t i, std::size_t k) const {
    return subpolygons_[i * size_ + k];
  }
  void set(std::size_t i, std::size_t k, const HoleSubpolygon& subpolygon) {
    subpolygons_[i * size_ + k] = subpolygon;
    angles_[i * size_ + k] = angles_before_[k * size_ + i] = subpolygon.weight.angle;
  }
  HoleSubpolygon best_between(std::size_t i, std::size_t k) const;

  const HoleBorder& border_;
  HoleWeights weigher_;
  std::size_t size_;
  /// Best triangulations of subpolygons, at index i * size_ + k.
  std::vector<HoleSubpolygon> subpolygons_;
  /// Largest angles of the subpolygons from i to k, for fast searches. `angles_` has them at index
  /// i * size_ + k, and `angles_before_` at index k * size_ + i.
  std::vector<double> angles_, angles_before_;
};

HoleSubpolygon LeastTriangulation::best_between(std::size_t i, std::size_t k) const {
  const double* left = angles_.data() + i * size_;
  const double* right = angles_before_.data() + k * size_;
  HoleSubpolygon best;
  const auto attempt = [&](std::size_t m) {
    const HoleSubpolygon &first = subpolygon(i, m), &second = subpolygon(m, k);
    if (m != best.apex && first.weight.is_there() && second.weight.is_there())
      weigher_.improve(i, m, k, first, second, best);
  };
  // Try the third corners of the triangles of two shorter subpolygons first. They often give a good
  // triangulation, which excludes most other candidates.
  for (const Index m : {subpolygon(i, k - 1).apex, subpolygon(i + 1, k).apex})
    if (m != no_index) attempt(m);
  for (std::size_t m = i + 1; m < k; ++m)
    if (std::max(left[m], right[m]) <= best.weight.angle) attempt(m);
  return best;
}

/// Dynamic programming as in LeastTriangulation, restricted to subpolygons from i to k for which
/// (i, k) is a given edge or an edge of the greedy triangulation.
class SparseTriangulation {
 public:
  using Edge = std::pair<Index, Index>;
  SparseTriangulation(const HoleBorder& border, std::vector<Edge> edges)
      : weigher_(border),
        size_(static_cast<Index>(border.points.size())),
        edges_(std::move(edges)),
        to_(size_),
        from_(size_) {
    for (Index i = 0; i < size_; ++i) edges_.push_back({i, (i + 1) % size_});
    for (const auto& [i, m, k] : greedy_triangulation(border))
      edges_.insert(edges_.end(), {{i, m}, {m, k}, {i, k}});
    for (auto& [i, k] : edges_) std::tie(i, k) = std::minmax({i, k});
    std::erase_if(edges_, [&](const Edge& e) {
      return e.first == e.second || is_chord(border, e.first, e.second);
    });
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
      return std::pair(a.second - a.first, a) < std::pair(b.second - b.first, b);
    });
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  std::vector<HoleTriangle> run() {
    for (const auto& [i, k] : edges_) {
      const HoleSubpolygon subpolygon =
          k == i + 1 ? HoleSubpolygon{{0, 0}, no_index} : best_between(i, k);
      if (!subpolygon.weight.is_there()) continue;
      to_[i].emplace_back(k, subpolygon);
      from_[k].emplace_back(i, subpolygon);
    }
    if (size_ < 3 || edges_.back() != Edge(0, size_ - 1) || to_[0].back().first != size_ - 1)
      return {};
    return triangles_below(size_, [&](Index i, Index k) {
      return std::lower_bound(to_[i].begin(), to_[i].end(), k,
                              [](const auto& entry, Index point) { return entry.first < point; })
          ->second.apex;
    });
  }

 private:
  using SubpolygonsTo = std::vector<std::pair<Index, HoleSubpolygon>>;
  HoleSubpolygon best_between(Index i, Index k) const;

  HoleWeights weigher_;
  Index size_;
  std::vector<Edge> edges_;
  std::vector<SubpolygonsTo> to_;  ///< for each point i the subpolygons from i to k, by ascending k
  /// For each point k the subpolygons from i to k, by descending i.
  std::vector<SubpolygonsTo> from_;
};

HoleSubpolygon SparseTriangulation::best_between(Index i, Index k) const {
  HoleSubpolygon best;
  auto right = from_[k].rbegin();
  for (const auto& [m, left] : to_[i]) {
    while (right != from_[k].rend() && right->first < m) ++right;
    if (right == from_[k].rend()) break;
    if (right->first == m) weigher_.improve(i, m, k, left, right->second, best);
  }
  return best;
}

}  // namespace

std::vector<HoleTriangle> least_triangulation(const HoleBorder& border) {
  return LeastTriangulation(border).run();
}

std::vector<HoleTriangle> sparse_triangulation(const HoleBorder& border) {
  std::vector<std::pair<Index, Index>> edges;
  const KdTree tree(border.points);
  for (Index i = 0; i < border.points.size(); ++i)
    for (const Index k : tree.nearest(border.points[i], nearest_tried)) edges.push_back({i, k});
  return triangulation_among(border, std::move(edges));
}

std::vector<HoleTriangle> triangulation_among(const HoleBorder& border,
                                              std::vector<std::pair<Index, Index>> edges) {
  return SparseTriangulation(border, std::move(edges)).run();
}

}  // namespace transformesh
