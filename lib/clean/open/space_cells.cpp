#include "clean/open/space_cells.h"

#include <algorithm>
#include <limits>

#include "mesh/disjoint_sets.h"

namespace transformesh {
namespace {

constexpr int unknown = std::numeric_limits<int>::min();

// Returns positions relative to the first point and divided by the size of the mesh, which avoids
// overflow and underflow.
std::vector<Vec3> normalized_positions(const Arrangement& arrangement) {
  std::vector<Vec3> positions(arrangement.point_count());
  double size = 0;
  for (Index i = 0; i < positions.size(); ++i) {
    positions[i] = arrangement.position(i) / 4 - arrangement.position(0) / 4;
    size = std::max(size, positions[i].cwiseAbs().maxCoeff());
  }
  for (Vec3& position : positions) position /= size;
  return positions;
}

}  // namespace

SpaceCells::SpaceCells(const Arrangement& arrangement, const Patches& patches,
                       const std::vector<char>& is_transparent) {
  DisjointSets sides = join_sides_around_edges(arrangement, patches);
  for (Index patch = 0; patch < patches.size(); ++patch) {
    if (is_transparent[patch]) sides.join(2 * patch, 2 * patch + 1);
  }
  for (Index side = 0; side < 2 * patches.size(); ++side) cell_of_.push_back(sides.find(side));
  spread_winding(arrangement, patches);
}

// Returns six times the signed volume of each cell, computed from its patches. The volume is
// positive if the patches enclose the cell.
std::vector<double> SpaceCells::volumes(const Arrangement& arrangement,
                                        const Patches& patches) const {
  const std::vector<Vec3> positions = normalized_positions(arrangement);
  std::vector<double> volumes(cell_of_.size(), 0);
  for (Index patch = 0; patch < patches.size(); ++patch) {
    double volume = 0;
    for (const Index p : patches.pieces[patch]) {
      const auto& [a, b, c] = arrangement.pieces[p].corners;
      volume += positions[a].dot(positions[b].cross(positions[c]));
    }
    volumes[cell_of_[std::size_t{2} * patch]] -= volume;
    volumes[cell_of_[std::size_t{2} * patch + 1]] += volume;
  }
  return volumes;
}

// Returns the cell of least volume in each connected set of cells. This is the unbounded cell: its
// signed volume is negative, because its patches do not enclose it.
std::vector<Index> SpaceCells::unbounded_cells(const std::vector<double>& volumes) const {
  DisjointSets sets(cell_of_.size());
  for (Index side = 0; side < cell_of_.size(); side += 2) {
    sets.join(cell_of_[side], cell_of_[side + 1]);
  }
  std::vector<Index> least(cell_of_.size(), no_index);
  for (const Index cell : cell_of_) {
    Index& best = least[sets.find(cell)];
    if (best == no_index || volumes[cell] < volumes[best]) best = cell;
  }
  std::erase(least, no_index);
  return least;
}

void SpaceCells::spread_winding(const Arrangement& arrangement, const Patches& patches) {
  std::vector<std::vector<Index>> sides(cell_of_.size());
  for (Index side = 0; side < cell_of_.size(); ++side) sides[cell_of_[side]].push_back(side);
  std::vector<Index> queue = unbounded_cells(volumes(arrangement, patches));
  std::vector<Index> distance(cell_of_.size(), no_index);
  winding_.assign(cell_of_.size(), unknown);
  for (const Index cell : queue) winding_[cell] = distance[cell] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const Index side : sides[queue[i]]) {
      const Index beyond = cell_of_[side ^ 1U];
      if (distance[beyond] <= distance[queue[i]]) continue;
      const int step = arrangement.pieces[patches.pieces[side / 2].front()].multiplicity;
      const int winding = winding_[queue[i]] + (side % 2 == 0 ? step : -step);
      winding_[beyond] = std::max(winding_[beyond], winding);
      if (distance[beyond] != no_index) continue;
      distance[beyond] = distance[queue[i]] + 1;
      queue.push_back(beyond);
    }
  }
}

}  // namespace transformesh
