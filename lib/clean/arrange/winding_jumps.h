/// Changes of the winding number w just in front of a plane. There, w is constant except across
/// segments in which other faces intersect or touch the plane from its front side (paper 3.2.2).
/// Faces of open components do not change w: w is the winding number of the closed part. Exact;
/// deterministic.
#pragma once

#include <utility>
#include <vector>

#include "clean/arrange/planes.h"
#include "mesh/edges.h"

namespace transformesh {

/// The change of the winding number w in front of a plane, from left to right of the segment in
/// which a face meets the plane.
struct WindingJump {
  Index face;  ///< the face that meets the plane; the first of several with the same three points
  int jump;
};

class WindingJumps {
 public:
  /// Keeps references to both arguments.
  WindingJumps(const WeldedMesh& welded, const Planes& planes);

  /// Returns the multiplicity of a face: by how much the winding number grows from its front to its
  /// back. The closed faces with the same three points count +1, or -1 if their orientation is
  /// opposite.
  int multiplicity(Index face) const { return multiplicities_.empty() ? 1 : multiplicities_[face]; }
  /// True if the face, or another face with the same three points, belongs to an open component
  /// (connected faces with borders).
  bool has_open_copy(Index face) const {
    return !has_open_copy_.empty() && has_open_copy_[face] != 0;
  }

  /// Returns the jump of the winding number across the segment from `from` to `to`, which is the
  /// intersection of two faces. The jump is measured beside one of these faces: the first face of
  /// `meeting` if `seen_from_first` is true, otherwise the second face. It is measured just in
  /// front of this face if `reversed` is false, otherwise just behind it.
  WindingJump over_segment(const Meeting& meeting, bool seen_from_first, bool reversed,
                           const ExactPoint& from, const ExactPoint& to) const;
  /// Appends the jumps across edge `i` of `face`, from the left to the right of the edge. They are
  /// measured just in front of the plane of the face with index `plane`. Only faces at the edge
  /// that are in front of this plane contribute.
  void over_edge(Index face, Index i, Index plane, std::vector<WindingJump>& jumps) const;

 private:
  const WeldedMesh& welded_;
  const Planes& planes_;
  void list_singular_edges();
  void count_copies();
  /// Calls visit(h) for all halfedges of the edge to which `halfedge` belongs, ascending.
  template <class Visit>
  void for_each_at_edge(Index halfedge, const Visit& visit) const;

  /// Result of multiplicity() for each face that is the first with its three points; empty if all
  /// are 1.
  std::vector<int> multiplicities_;
  /// Result of has_open_copy() for each face that is the first with its three points; empty if no
  /// face is open.
  std::vector<char> has_open_copy_;
  /// Pairs of a halfedge without an opposite and its edge, ascending.
  std::vector<std::pair<Index, Index>> singular_edge_of_;
};

}  // namespace transformesh
