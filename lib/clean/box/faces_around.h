/// Faces around others, ring by ring. A ring has the faces that come as near to one of the others
/// as rounding could move a vertex. It may have more of those that have a cell of a grid in common
/// with one. Deterministic. Cost: O(n) per ring, and 64 bytes for each cell of the faces.
#pragma once

#include <utility>
#include <vector>

#include "geometry/search/cell_grid.h"
#include "transformesh/measure.h"

namespace transformesh {

class FacesAround {
 public:
  /// Begins with some faces. Keeps a reference to the mesh.
  FacesAround(const Mesh& mesh, std::vector<bool> faces, const CellGrid& grid, Scalar coordinate);

  /// Adds a ring.
  void grow();
  /// The faces so far, and those with a further ring.
  const std::vector<bool>& faces() const { return faces_; }
  std::vector<bool> next() const;
  /// Hands over the cells of the faces so far.
  CellMarks take_cells() { return std::move(marks_); }

 private:
  template <class Visit>
  void visit_ring(const Visit& visit) const;
  void mark(const std::vector<Cell>& cells, Index round);

  const Mesh& mesh_;
  std::vector<bool> faces_;
  CellGrid grid_;
  Scalar coordinate_;
  double margin_;
  Index rings_ = 0;
  CellMarks marks_;
};

}  // namespace transformesh
