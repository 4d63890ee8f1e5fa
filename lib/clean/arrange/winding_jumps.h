/// Changes of the winding number w in front of a plane. In front of a plane, w is constant except
/// across segments at which other faces meet the plane from the front (paper 3.2.2). Faces of open
/// components do not change w: w is the winding number of the closed part. Exact; deterministic.
#pragma once

#include <utility>
#include <vector>

#include "clean/arrange/planes.h"
#include "mesh/edges.h"

namespace transformesh {

/// The change of the winding number w in front of a plane, from left to right of the segment in
/// which a face meets the plane.
struct WindingJump {
  Index face;  ///< the first copy of the face that meets the plane
  int jump;
};

class WindingJumps {
 public:
  /// Keeps references to both arguments.
  WindingJumps(const WeldedMesh& welded, const Planes& planes);

  /// Number of closed copies of a face minus the number of reversed ones.
  int multiplicity(Index face) const { return multiplicities_.empty() ? 1 : multiplicities_[face]; }
  /// True if a copy of the face is open.
  bool has_open_copy(Index face) const {
    return !has_open_copy_.empty() && has_open_copy_[face] != 0;
  }

  /// Returns the jump across [from, to], the common segment of two faces. The jump is in front of
  /// the first face if `seen_from_first`, else in front of the second face. It is behind this face
  /// if `reversed`.
  WindingJump over_segment(const Meeting& meeting, bool seen_from_first, bool reversed,
                           const ExactPoint& from, const ExactPoint& to) const;
  /// Appends the jumps across edge `i` of `face`, in the direction of that edge. `plane` is a face
  /// in the plane. Only faces at the edge that are in front of the plane contribute.
  void over_edge(Index face, Index i, Index plane, std::vector<WindingJump>& jumps) const;

 private:
  const WeldedMesh& welded_;
  const Planes& planes_;
  void list_singular_edges();
  void count_copies();
  /// Calls visit(halfedge) for the halfedges of the edge of a halfedge, ascending.
  template <class Visit>
  void for_each_at_edge(Index halfedge, const Visit& visit) const;

  std::vector<int> multiplicities_;  ///< multiplicity of each first copy; empty if all are 1
  std::vector<char> has_open_copy_;  ///< one for each first copy; empty if all faces are closed
  /// Each halfedge without an opposite, with its edge; ascending.
  std::vector<std::pair<Index, Index>> singular_edge_of_;
};

}  // namespace transformesh
