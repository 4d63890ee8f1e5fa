/// Interface of operations that keep the boundary of another region than { p : w(p) >= winding
/// level }, for example Boolean operations. Such an operation selects the pieces of the arrangement
/// that bound its region.
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

  /// Sets WeldedMesh::open_component if the operation treats some faces as a sheet, which does not
  /// enclose anything. Called before the other functions.
  virtual void mark_open(WeldedMesh& welded) const = 0;

  /// Returns true if the region of the operation is { p : w(p) >= winding level }. Then choose() is
  /// not called. `meetings` are the intersecting pairs of faces of the welded mesh.
  virtual bool is_level_set(const WeldedMesh& welded,
                            const std::vector<Meeting>& meetings) const = 0;

  /// Sets the `kept` entries of the pieces that bound the region to 1; all entries are 0 before the
  /// call. Reverses pieces if necessary, so that the region is behind them. `arrangement` contains
  /// all pieces. May change the multiplicities of pieces, but only to 0 if the piece is not on the
  /// boundary of the region.
  virtual void choose(Arrangement& arrangement, std::vector<char>& kept) const = 0;
};

}  // namespace transformesh
