#include "io/polygons/remaining_corners.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/numbers/predicates.h"

namespace transformesh {
namespace {

/// Returns, for each point, the lowest index of a point equal to it.
std::vector<std::uint32_t> lowest_equal(std::span<const Eigen::Vector2d> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::make_tuple(points[a][0], points[a][1], a) <
           std::make_tuple(points[b][0], points[b][1], b);
  });
  std::vector<std::uint32_t> lowest(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && points[order[i]] == points[order[i - 1]];
    lowest[order[i]] = is_equal ? lowest[order[i - 1]] : order[i];
  }
  return lowest;
}

}  // namespace

RemainingCorners::RemainingCorners(std::span<const Vec3> positions, std::span<const Index> vertices,
                                   std::span<const Eigen::Vector2d> points)
    : positions_(positions),
      vertices_(vertices),
      points_(points),
      next_(points.size()),
      previous_(points.size()),
      place_(lowest_equal(points)),
      size_(points.size()) {
  for (std::uint32_t i = 0; i < size_; ++i) {
    next_[i] = i + 1 < size_ ? i + 1 : 0;
    previous_[next_[i]] = i;
  }
}

std::vector<std::uint32_t> RemainingCorners::corners() const {
  std::vector<std::uint32_t> corners;
  corners.reserve(size_);
  for (std::uint32_t corner = first_; corners.size() < size_; corner = next_[corner])
    corners.push_back(corner);
  return corners;
}

bool RemainingCorners::has_twins() const {
  for (std::size_t i = 0; i < place_.size(); ++i)
    if (vertices_[i] != vertices_[place_[i]]) return true;
  return false;
}

void RemainingCorners::remove_coincident() {
  std::uint32_t corner = first_;
  for (std::size_t unchanged = 0; size_ > 2 && unchanged < size_;) {
    const std::uint32_t before = previous_[corner], behind = next_[corner];
    if (place_[corner] == place_[before] || place_[before] == place_[behind]) {
      cut(corner, upright);
      corner = before;
      unchanged = unchanged > 1 ? unchanged - 2 : 0;
    } else {
      corner = behind;
      ++unchanged;
    }
  }
}

void RemainingCorners::cut_edge(std::uint32_t corner, std::size_t count) {
  if (size_ < 3 || !is_there(corner)) return;
  if (area(next_[corner]) < area(corner)) corner = next_[corner];
  for (; count > 0 && size_ > 2; --count) {
    const std::uint32_t behind = next_[corner];
    cut(corner, folds);
    corner = behind;
  }
}

void RemainingCorners::cut_fan() {
  while (size_ > 2) cut(next_[first_], folds);
}

void RemainingCorners::add(const CornerTriangle& triangle, std::size_t& kind) {
  const auto& [a, b, c] = triangle;
  const bool is_triangle =
      vertices_[a] != vertices_[b] && vertices_[b] != vertices_[c] && vertices_[c] != vertices_[a];
  if (!is_triangle) return;
  triangles.push_back(triangle);
  if (!collinear(positions_[a], positions_[b], positions_[c])) ++kind;
}

void RemainingCorners::cut(std::uint32_t corner, std::size_t& kind) {
  const std::uint32_t before = previous_[corner], behind = next_[corner];
  add({before, corner, behind}, kind);
  next_[before] = behind;
  previous_[behind] = before;
  next_[corner] = previous_[corner] = corner;
  if (first_ == corner) first_ = behind;
  --size_;
}

double RemainingCorners::area(std::uint32_t corner) const {
  const Eigen::Vector2d a = points_[previous_[corner]] - points_[corner];
  const Eigen::Vector2d b = points_[next_[corner]] - points_[corner];
  return std::abs(a[0] * b[1] - a[1] * b[0]);
}

}  // namespace transformesh
