#include "clean/intersect/embedded_stars.h"

#include <algorithm>
#include <bit>

namespace transformesh {
namespace {

// Returns for each wanted point the axis directions in which all its faces have positive projected
// area. Returns no direction if an edge of the point does not have exactly two faces with opposite
// halfedges.
std::vector<AxisDirections> find_common_directions(const WeldedMesh& welded,
                                                   std::span<const char> is_wanted) {
  std::vector<AxisDirections> common(welded.points.size());
  for (std::size_t p = 0; p < common.size(); ++p)
    common[p] = is_wanted[p] ? all_axis_directions : 0;
  for (std::size_t f = 0; f < welded.faces.size(); ++f) {
    const Face& face = welded.faces[f];
    if ((common[face[0]] | common[face[1]] | common[face[2]]) == 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      common[face[i]] &= welded.directions[f].looks;
      if (welded.opposites[3 * f + i] == no_index) common[face[i]] = common[face[(i + 1) % 3]] = 0;
    }
  }
  return common;
}

}  // namespace

// In the projection along a common direction, the point is to the left of each opposite edge. These
// edges form closed polygons around the point. The number of turns is the number of times that
// these edges cross, upwards, the ray that runs from the point to the right.
std::vector<char> find_embedded_stars(const WeldedMesh& welded, std::span<const char> is_wanted) {
  const std::vector<AxisDirections> directions = find_common_directions(welded, is_wanted);
  std::vector<char> turns(welded.points.size(), 0);
  const auto cross_ray = [&](Index point, Index from, Index to) {
    const int way = std::countr_zero(directions[point]);
    if (way % 2 == 1) std::swap(from, to);
    const int up = (way / 2 + 2) % 3;
    const double height = welded.points[point][up];
    const bool crosses = welded.points[from][up] <= height && height < welded.points[to][up];
    turns[point] = static_cast<char>(std::min(2, turns[point] + (crosses ? 1 : 0)));
  };
  for (const auto& [a, b, c] : welded.faces) {
    if (directions[a] != 0) cross_ray(a, b, c);
    if (directions[b] != 0) cross_ray(b, c, a);
    if (directions[c] != 0) cross_ray(c, a, b);
  }
  for (std::size_t p = 0; p < turns.size(); ++p)
    turns[p] = directions[p] != 0 && turns[p] == 1 ? 1 : 0;
  return turns;
}

std::vector<char> find_embedded_stars(const WeldedMesh& welded) {
  return find_embedded_stars(welded, std::vector<char>(welded.points.size(), 1));
}

}  // namespace transformesh
