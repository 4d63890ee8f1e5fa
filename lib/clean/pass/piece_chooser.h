/// Selects the pieces that bound the region of an operation on a mesh, instead of the region { p :
/// w(p) >= winding level }.
#pragma once

#include <vector>

#include "clean/arrange/arrange.h"

namespace transformesh {

class PieceChooser {
 public:
  PieceChooser() = default;
  virtual ~PieceChooser() = default;
  PieceChooser(const PieceChooser&) = delete;
  PieceChooser& operator=(const PieceChooser&) = delete;

  /// Marks open components (WeldedMesh::open_component) if the operation treats some faces as a
  /// sheet. Is called before the other functions.
  virtual void mark_open(WeldedMesh& welded) const = 0;

  /// Returns true if the region of the operation is { p : w(p) >= winding level }. Then choose() is
  /// not called. `meetings` are those of the welded mesh.
  virtual bool is_level_set(const WeldedMesh& welded,
                            const std::vector<Meeting>& meetings) const = 0;

  /// Marks the kept pieces of the whole arrangement, and reverses pieces if necessary so that the
  /// region is behind them. All entries of `kept` are 0 before the call. May change multiplicities
  /// of pieces; a multiplicity may become 0 only if the piece is not on a boundary.
  virtual void choose(Arrangement& arrangement, std::vector<char>& kept) const = 0;
};

}  // namespace transformesh
