/// Bodies whose flat sides are divided into many faces.
#pragma once

#include <array>
#include <map>
#include <set>

#include "transformesh/mesh.h"

namespace transformesh::test {

using Cell = std::array<int, 3>;

/// The boundary of unit cells. Each of their sides is a grid of n x n squares of two
/// triangles.
class CellSurface {
 public:
  CellSurface(const std::set<Cell>& cells, int n) : n_(n) {
    for (const Cell& cell : cells)
      for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
          Cell beside = cell;
          beside[axis] += 2 * side - 1;
          if (!cells.contains(beside)) add_side(cell, axis, side);
        }
  }
  Mesh mesh;

 private:
  void add_side(const Cell& cell, int axis, int side) {
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) {
        const auto at = [&](int u, int v) {
          Cell place{};
          place[axis] = (cell[axis] + side) * n_;
          place[(axis + 1) % 3] = cell[(axis + 1) % 3] * n_ + i + u;
          place[(axis + 2) % 3] = cell[(axis + 2) % 3] * n_ + j + v;
          return vertex(place);
        };
        const Index a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
        mesh.faces.push_back(side == 1 ? Face{a, b, c} : Face{a, c, b});
        mesh.faces.push_back(side == 1 ? Face{a, c, d} : Face{a, d, c});
      }
  }
  Index vertex(const Cell& place) {
    const auto [found, is_new] =
        vertices_.emplace(place, static_cast<Index>(mesh.positions.size()));
    if (is_new)
      mesh.positions.push_back(Vec3(place[0], place[1], place[2]) / static_cast<double>(n_));
    return found->second;
  }

  int n_;
  std::map<Cell, Index> vertices_;
};

inline Mesh grid_cube(int n) { return CellSurface({{0, 0, 0}}, n).mesh; }

/// Returns three by three cells without the middle one: a ring of genus 1 with a square hole.
inline Mesh grid_frame(int n) {
  std::set<Cell> cells;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      if (x != 1 || y != 1) cells.insert({x, y, 0});
  return CellSurface(cells, n).mesh;
}

}  // namespace transformesh::test
