/// Region growing (paper 3.2) over a mesh before any face is cut. Finds the winding number w in
/// front of each face, near each corner. Only the closed faces of the mesh determine w, but w is
/// also found in front of open faces. Two neighbors have the same w in front, next to their common
/// edge. Along an edge, w changes at closed faces that intersect the edge. Whole faces are those
/// without intersections; other faces are cut faces. A ray gives w in front of one whole face of
/// each connected component (paper 3.2.1). Hence w is found once for each region of connected whole
/// faces, and at each corner of the cut faces between the regions. Only the regions are found in
/// parallel. If only a part of a mesh is loaded, faces whose surroundings are missing
/// (surroundings.h) do not propagate w. Then a cut face gets its own ray if it is not connected to
/// a whole face. Cost: O(n + k) for k pairs, and a ray per component. Exact; deterministic.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "clean/arrange/planes.h"
#include "clean/arrange/winding_jumps.h"
#include "clean/exterior/ray_cast_front_winding.h"
#include "support/raw_vector.h"

namespace transformesh {

class RegionGrowingWinding {
 public:
  /// Keeps references to all arguments.
  RegionGrowingWinding(const WeldedMesh& welded, const Planes& planes, const WindingJumps& jumps,
                       const Surroundings* around = nullptr);

  /// Returns the winding number w in front of a face near its corner `i`. Returns nothing if
  /// another face that is not a neighbor contains the corner, or if the face is not connected to a
  /// whole face (a face without intersections).
  std::optional<int> at(Index face, Index i) const {
    if (has_no_closed_face_) return 0;
    const int w = planes_.is_whole(face) ? region_front_[region_of_[face]] : at_cut_face(face, i);
    return w == unknown ? std::nullopt : std::optional(w);
  }
  /// True if the face of a plane certainly has no part with winding number w < winding level in
  /// front and w >= winding level behind. False does not mean that the face has such a part.
  bool is_hidden(const Plane& plane, int winding_level) const;
  std::size_t rays() const { return rays_; }

 private:
  static constexpr int unknown = std::numeric_limits<int>::min();
  /// Changes of the winding number w in front of a cut face along its edges.
  struct CutFace {
    std::array<int, 3> along{};  ///< change of the winding number from corner i to the next corner
    /// True if a face that intersects the cut face contains corner i.
    std::array<bool, 3> is_met{};
  };

  int at_cut_face(Index face, Index i) const {
    return welded_.first_copy[face] == face ? front_[3 * planes_.plane_of(face) + i] : unknown;
  }
  CutFace trace(const Plane& plane) const;
  void trace_meeting(const Meeting& meeting, Index face, CutFace& cut) const;
  bool is_complete(Index face) const { return !around_ || around_->is_complete[face]; }
  void leave_out_incomplete();
  void find_regions();
  void list_neighbors();
  void grow();
  void grow_from_cut_faces();
  int cast_at_corner(const RayCastFrontWinding& ray, Index face, Index i) const;
  Index seed_near(Index face) const;
  void spread();
  void spread_from_region(Index region);
  void spread_from_corner(Index corner);
  void visit_face(Index face, Index i, int w);
  void visit_region(Index region, int w);
  void visit_corner(Index face, Index i, int w);

  const WeldedMesh& welded_;
  const Planes& planes_;
  const WindingJumps& jumps_;
  const Surroundings* around_;  ///< null unless the mesh is a part of a larger mesh
  /// True if there are no closed faces, so that the winding number is 0 everywhere.
  bool has_no_closed_face_ = false;
  /// Changes of the winding number along the edges of the first face of each plane.
  std::vector<CutFace> cut_faces_;
  /// Opposite halfedges; no_index if the faces around one of the two faces are not all loaded.
  std::vector<Index> complete_across_;
  std::span<const Index> across_;  ///< opposite of each halfedge, or no_index
  /// Region (connected faces without intersections) of each face; no_index for a cut face.
  RawVector<Index> region_of_;
  RawVector<Index> first_face_;  ///< face with the lowest index of each region
  /// For each region the halfedges of cut faces next to the region, in one list.
  std::vector<Index> cut_at_;
  std::vector<Index> cut_offsets_;   ///< index in `cut_at_` of the first halfedge of each region
  std::vector<int> region_front_;    ///< winding number in front of each region
  std::vector<int> front_;           ///< winding number in front of each cut face at its corners
  std::vector<Index> region_stack_;  ///< regions whose neighbors have to be visited
  std::vector<Index> corner_stack_;  ///< corners of cut faces whose neighbors have to be visited
  std::size_t rays_ = 0;
};

}  // namespace transformesh
