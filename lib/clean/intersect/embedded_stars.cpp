#include "clean/intersect/embedded_stars.h"

#include <atomic>
#include <bit>
#include <utility>

#include "support/parallel.h"

namespace transformesh {
namespace {

// Returns for each wanted point the axis directions in which all faces at the point have positive
// projected area. The set is empty if an edge at the point does not have exactly two faces with
// opposite halfedges.
std::vector<AxisDirections> find_common_directions(const WeldedMesh& welded,
                                                   std::span<const char> is_wanted) {
  std::vector<AxisDirections> common(welded.points.size());
  parallel_for_each(common.size(),
                    [&](std::size_t p) { common[p] = is_wanted[p] ? all_axis_directions : 0; });
  const auto keep = [&](Index point, AxisDirections directions) {
    const std::atomic_ref at(common[point]);
    const AxisDirections known = at.load(std::memory_order_relaxed);
    if ((known & directions) != known) at.fetch_and(directions, std::memory_order_relaxed);
  };
  parallel_for_each(welded.faces.size(), [&](std::size_t f) {
    const Face& face = welded.faces[f];
    if (!is_wanted[face[0]] && !is_wanted[face[1]] && !is_wanted[face[2]]) return;
    for (std::size_t i = 0; i < 3; ++i) {
      keep(face[i], welded.directions[f].looks);
      if (welded.opposites[3 * f + i] != no_index) continue;
      keep(face[i], 0);
      keep(face[(i + 1) % 3], 0);
    }
  });
  return common;
}

// Increments `turns` atomically, up to 2.
void count_turn(char& turns) {
  const std::atomic_ref shared(turns);
  char known = shared.load(std::memory_order_relaxed);
  while (known < 2 && !shared.compare_exchange_weak(known, static_cast<char>(known + 1),
                                                    std::memory_order_relaxed)) {
  }
}

}  // namespace

// Projects the faces at a point along a direction in which all of them have positive area. Each
// face has one edge that does not contain the point; the point is to the left of these edges. The
// edges form closed polygons around the point. The number of turns of these polygons is the number
// of times that they cross, upwards, the ray that runs from the point to the right.
std::vector<char> find_embedded_stars(const WeldedMesh& welded, std::span<const char> is_wanted) {
  const std::vector<AxisDirections> directions = find_common_directions(welded, is_wanted);
  std::vector<char> turns(welded.points.size(), 0);
  const auto cross_ray = [&](Index point, Index from, Index to) {
    const int way = std::countr_zero(directions[point]);
    if (way % 2 == 1) std::swap(from, to);
    const int up = (way / 2 + 2) % 3;
    const double height = welded.points[point][up];
    const bool crosses = welded.points[from][up] <= height && height < welded.points[to][up];
    if (crosses) count_turn(turns[point]);
  };
  parallel_for_each(welded.faces.size(), [&](std::size_t f) {
    const auto& [a, b, c] = welded.faces[f];
    if (directions[a] != 0) cross_ray(a, b, c);
    if (directions[b] != 0) cross_ray(b, c, a);
    if (directions[c] != 0) cross_ray(c, a, b);
  });
  parallel_for_each(turns.size(),
                    [&](std::size_t p) { turns[p] = directions[p] != 0 && turns[p] == 1 ? 1 : 0; });
  return turns;
}

std::vector<char> find_embedded_stars(const WeldedMesh& welded) {
  return find_embedded_stars(welded, std::vector<char>(welded.points.size(), 1));
}

}  // namespace transformesh
