#include "corpus/chains/convex.h"

#include <algorithm>
#include <cmath>

namespace chains {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point scaled_sum(const Point& a, double s, const Point& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

bool is_same(const HalfSpace& a, const HalfSpace& b) {
  return dot(a.normal, b.normal) > 1 - 1e-13 && std::abs(a.offset - b.offset) < 1e-12;
}

/// Returns a square in the plane of the half-space that extends far beyond the body.
std::vector<Point> square_in(const HalfSpace& plane, double reach) {
  const auto k = static_cast<std::size_t>(
      std::min_element(plane.normal.begin(), plane.normal.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      plane.normal.begin());
  Point axis{};
  axis[k] = 1;
  Point u = cross(plane.normal, axis);
  u = scaled_sum({}, 1 / std::sqrt(dot(u, u)), u);
  const Point v = cross(plane.normal, u), middle = scaled_sum({}, plane.offset, plane.normal);
  std::vector<Point> square;
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    square.push_back(scaled_sum(scaled_sum(middle, s * reach, u), t * reach, v));
  return square;
}

std::vector<Point> clip(const std::vector<Point>& polygon, const HalfSpace& half_space) {
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double start = half_space.offset - dot(half_space.normal, from);
    const double end = half_space.offset - dot(half_space.normal, to);
    if (start >= 0) result.push_back(from);
    if ((start < 0) == (end < 0)) continue;
    const double share = start / (start - end);
    result.push_back(scaled_sum(scaled_sum(from, -share, from), share, to));
  }
  return result;
}

double area_of(const std::vector<Point>& polygon, const Point& normal) {
  double area = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    area += dot(normal, cross(scaled_sum(polygon[i - 1], -1, polygon[0]),
                              scaled_sum(polygon[i], -1, polygon[0]))) /
            2;
  return std::abs(area);
}

/// Adds up volumes over all sets of the `count` bodies whose intersection is `common`, and at least
/// one body from `next` on. Each volume is multiplied by its coefficient of inclusion and exclusion
/// for the winding level.
double alternating_sum(int level, const std::vector<ConvexBody>& bodies, std::size_t next,
                       const ConvexBody& common, int count, double reach) {
  double sum = 0;
  for (std::size_t i = next; i < bodies.size(); ++i) {
    ConvexBody smaller = common;
    smaller.insert(smaller.end(), bodies[i].begin(), bodies[i].end());
    const double volume = volume_of(smaller, reach);
    if (volume <= 1e-12) continue;
    const int size = count + 1, sign = (size - level) % 2 == 0 ? 1 : -1;
    sum += sign * (level == 1 ? 1 : size - 1) * volume +
           alternating_sum(level, bodies, i + 1, smaller, size, reach);
  }
  return sum;
}

}  // namespace

double volume_of(const ConvexBody& body, double reach) {
  double volume = 0;
  // starting at a corner makes the volume of a flat body exactly 0, however it is rounded
  Point apex{};
  bool has_apex = false;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const auto is_earlier = [&](const HalfSpace& other) { return is_same(other, body[i]); };
    const auto self = body.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(body.begin(), self, is_earlier)) continue;
    std::vector<Point> facet = square_in(body[i], 4 * reach);
    for (const HalfSpace& other : body)
      if (!is_same(other, body[i])) facet = clip(facet, other);
    if (facet.empty()) continue;
    if (!has_apex) apex = facet.front();
    has_apex = true;
    volume += (body[i].offset - dot(body[i].normal, apex)) * area_of(facet, body[i].normal) / 3;
  }
  return volume;
}

double volume_at_winding_level(int level, const std::vector<ConvexBody>& bodies, double reach) {
  return alternating_sum(level, bodies, 0, {}, 0, reach);
}

}  // namespace chains
