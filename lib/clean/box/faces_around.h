/// Grows a set of faces ring by ring. A ring contains all faces that share a grid cell with a face
/// of the set, and so all faces that may meet it after rounding moved vertices. Deterministic.
/// Cost: O(n) per ring, and 64 bytes per cell of the faces.
#pragma once

#include <utility>
#include <vector>

#include "geometry/search/cell_grid.h"
#include "transformesh/measure.h"

namespace transformesh {

class FacesAround {
 public:
  /// Starts with the given faces. Keeps a reference to the mesh.
  FacesAround(const Mesh& mesh, std::vector<bool> faces, const CellGrid& grid, Scalar coordinate);

  /// Adds one ring.
  void grow();
  /// Returns the faces of the set. next() returns the set with one more ring, and does not change
  /// this object.
  const std::vector<bool>& faces() const { return faces_; }
  std::vector<bool> next() const;
  CellMarks take_cells() { return std::move(marks_); }

 private:
  template <class Visit>
  void visit_ring(const Visit& visit) const;
  void mark(const std::vector<Cell>& cells, Index round);

  const Mesh& mesh_;
  std::vector<bool> faces_;
  CellGrid grid_;
  double margin_;
  Index rings_ = 0;
  CellMarks marks_;
};

}  // namespace transformesh
