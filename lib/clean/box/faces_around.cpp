#include "clean/box/faces_around.h"

#include <algorithm>

#include "clean/box/box_submesh.h"

namespace transformesh {
FacesAround::FacesAround(const Mesh& mesh, std::vector<bool> faces, const CellGrid& grid,
                         Scalar coordinate)
    : mesh_(mesh),
      faces_(std::move(faces)),
      grid_(grid),
      margin_(margin_around(bounding_box(mesh), coordinate)) {
  std::vector<Cell> cells;
  for (Index f = 0; f < faces_.size(); ++f) {
    if (!faces_[f]) continue;
    grid_.find(triangle_of(mesh_, f), margin_, cells);
    mark(cells, 0);
  }
}

void FacesAround::mark(const std::vector<Cell>& cells, Index round) {
  for (const Cell cell : cells) marks_.add(cell, 0, round);
}

// Calls visit(face, cells) for each face of the next ring: faces that share a grid cell with the
// faces of the set. `cells` are the grid cells of the face. A cell that two faces share is within
// the margin of both. The faces are thus at most two margins and a cell apart along each axis; a
// hundredth of a cell exceeds rounding errors.
template <class Visit>
void FacesAround::visit_ring(const Visit& visit) const {
  Box box = box_around(mesh_, faces_);
  const double reach = 2 * margin_ + 1.01 * grid_.size();
  box.min().array() -= reach;
  box.max().array() += reach;
  const std::vector<bool> near = faces_near(mesh_, box);
  const auto is_marked = [&](Cell cell) {
    return marks_.visit(cell, rings_ + 1, [](Index) { return true; });
  };
  std::vector<Cell> cells;
  for (Index f = 0; f < near.size(); ++f) {
    if (!near[f] || faces_[f]) continue;
    grid_.find(triangle_of(mesh_, f), margin_, cells);
    if (std::any_of(cells.begin(), cells.end(), is_marked)) visit(f, cells);
  }
}

void FacesAround::grow() {
  std::vector<bool> grown = faces_;
  visit_ring([&](Index f, const std::vector<Cell>& cells) {
    grown[f] = true;
    mark(cells, rings_ + 1);
  });
  faces_ = std::move(grown);
  ++rings_;
}

std::vector<bool> FacesAround::next() const {
  std::vector<bool> grown = faces_;
  visit_ring([&](Index f, const std::vector<Cell>&) { grown[f] = true; });
  return grown;
}

}  // namespace transformesh
