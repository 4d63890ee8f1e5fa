/// The choice of the pieces that bound the region which an operation on a mesh selects, in place of
/// { p : w(p) >= winding level }.
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
  /// Called before all else.
  virtual void mark_open(WeldedMesh& welded) const = 0;

  /// Returns whether the boundary of { p : w(p) >= winding level } is that of the region. Then
  /// `choose` is not called. `meetings` are those of the welded mesh.
  virtual bool is_level_set(const WeldedMesh& welded,
                            const std::vector<Meeting>& meetings) const = 0;

  /// Marks the kept pieces of the whole arrangement, which come unmarked, and turns them so that
  /// the region lies behind them. May change multiplicities: 0 only for pieces that part nothing.
  virtual void choose(Arrangement& arrangement, std::vector<char>& kept) const = 0;
};

}  // namespace transformesh
