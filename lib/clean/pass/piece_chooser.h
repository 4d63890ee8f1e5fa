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

  /// Marks open components (WeldedMesh::open_component) if the operation treats faces as a sheet.
  /// Called before the other functions.
  virtual void mark_open(WeldedMesh& welded) const = 0;

  /// Returns true if the region of the operation is { p : w(p) >= winding level }. Then choose() is
  /// not called. `meetings` are those of the welded mesh.
  virtual bool is_level_set(const WeldedMesh& welded,
                            const std::vector<Meeting>& meetings) const = 0;

  /// Marks the kept pieces of the whole arrangement, and reverses pieces if necessary so that the
  /// region is behind them. All of `kept` is 0 before. May change multiplicities, but to 0 only if
  /// the piece separates nothing.
  virtual void choose(Arrangement& arrangement, std::vector<char>& kept) const = 0;
};

}  // namespace transformesh
