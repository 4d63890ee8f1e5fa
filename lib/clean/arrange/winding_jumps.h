/// Changes of the winding number w across faces, seen from the front of a plane. There w is
/// constant except where a face meets the plane from the front (paper 3.2.2). Faces of open
/// components change nothing: w is the winding number of the closed part. Exact; deterministic.
#pragma once

#include <vector>

#include "clean/arrange/planes.h"
#include "mesh/edges.h"

namespace transformesh {

/// A face, and by how much w in front of a plane grows from left to right of a segment in which the
/// face meets the plane.
struct WindingJump {
  Index face;  ///< of copies the first
  int jump;
};

class WindingJumps {
 public:
  /// Keeps references.
  WindingJumps(const WeldedMesh& welded, const Planes& planes);

  /// How many closed copies of a face there are, less those that are reversed.
  int multiplicity(Index face) const { return multiplicities_.empty() ? 1 : multiplicities_[face]; }
  /// Whether one of its copies is open.
  bool has_open_copy(Index face) const {
    return !has_open_copy_.empty() && has_open_copy_[face] != 0;
  }

  /// Over the common segment of two faces, seen from the front of one of them (from its back, if
  /// that is `reversed`). [from, to] is the segment.
  WindingJump over_segment(const Meeting& meeting, bool seen_from_first, bool reversed,
                           const ExactPoint& from, const ExactPoint& to) const;
  /// Over edge i of a face in a plane, along the face, the steps of all faces at that edge that
  /// rise to the front of the plane, which is given by a face.
  void over_edge(Index face, Index i, Index plane, std::vector<WindingJump>& jumps) const;

 private:
  const WeldedMesh& welded_;
  const Planes& planes_;
  void count_copies();

  std::vector<int> multiplicities_;  ///< per first copy; empty if each face counts once
  std::vector<char> has_open_copy_;  ///< per first copy; empty if all faces are closed
  std::vector<Index> edge_of_;       ///< per halfedge
};

}  // namespace transformesh
