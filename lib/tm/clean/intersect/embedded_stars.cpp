#include "tm/clean/intersect/embedded_stars.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "tm/support/parallel.h"

namespace transformesh {
namespace {

constexpr std::size_t faces_per_task = 4096;

/// Above the error of the area of a projected triangle, relative to its two products.
constexpr double area_error = 1e-15;
constexpr double underflow_guard = 1e-280;

/// The ways that a face looks for certain: bit 2 * axis for up that axis, the bit above for down.
using Ways = std::uint8_t;
constexpr Ways all_ways = 0x3f;

Ways ways_of(const Triangle& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  Ways ways = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double left = u[i] * v[j], right = u[j] * v[i];
    const double error = area_error * (std::abs(left) + std::abs(right)) + underflow_guard;
    const double area = left - right;
    ways |= static_cast<Ways>((area > error ? 1U : area < -error ? 2U : 0U) << (2 * axis));
  }
  return ways;
}

// Per point, the ways that all its faces look; none where it has no faces, or an edge without two
// faces that run along it in opposite directions.
std::vector<Ways> find_common_ways(const WeldedMesh& welded) {
  const std::vector<Face>& faces = welded.faces;
  std::vector<Ways> of_face(faces.size());
  parallel_for(faces.size(), faces_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f)
      of_face[f] = ways_of(welded.triangle(static_cast<Index>(f)));
  });
  std::vector<Ways> ways(welded.points.size(), all_ways);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const Index point : faces[f]) ways[point] &= of_face[f];

  const auto source = [&](Index h) { return faces[h / 3][h % 3]; };
  for (std::size_t e = 0; e < welded.edges.size(); ++e) {
    const auto halfedges = welded.edges.halfedges(e);
    if (halfedges.size() == 2 && source(halfedges[0]) != source(halfedges[1])) continue;
    const Face& face = faces[halfedges[0] / 3];
    ways[face[halfedges[0] % 3]] = ways[face[(halfedges[0] + 1) % 3]] = 0;
  }
  return ways;
}

}  // namespace

// Seen along a way that all faces look, every edge opposite to the point leaves it on its left. So
// these edges, which are closed polygons, go around it as often as they cross the ray to its right,
// upwards.
std::vector<char> find_embedded_stars(const WeldedMesh& welded) {
  const std::vector<Ways> ways = find_common_ways(welded);
  std::vector<char> turns(welded.points.size(), 0);
  const auto cross_ray = [&](Index point, Index from, Index to) {
    const int way = std::countr_zero(ways[point]);
    if (way % 2 == 1) std::swap(from, to);
    const int up = (way / 2 + 2) % 3;
    const double height = welded.points[point][up];
    const bool crosses = welded.points[from][up] <= height && height < welded.points[to][up];
    turns[point] = static_cast<char>(std::min(2, turns[point] + (crosses ? 1 : 0)));
  };
  for (const auto& [a, b, c] : welded.faces) {
    if (ways[a] != 0) cross_ray(a, b, c);
    if (ways[b] != 0) cross_ray(b, c, a);
    if (ways[c] != 0) cross_ray(c, a, b);
  }
  std::vector<char> is_embedded(welded.points.size());
  for (std::size_t p = 0; p < is_embedded.size(); ++p)
    is_embedded[p] = ways[p] != 0 && turns[p] == 1 ? 1 : 0;
  return is_embedded;
}

}  // namespace transformesh
