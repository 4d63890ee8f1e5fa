/// Region growing (paper 3.2) over a mesh before any face is cut. Finds the winding number w of the
/// closed part in front of each face, including open faces, near each corner. Two neighbors have
/// the same w in front, next to their common edge. Along an edge, w changes at closed faces that
/// intersect the edge. A ray gives w in front of one whole face of each connected component (paper
/// 3.2.1). In a part of a mesh, incomplete faces do not propagate w. There, a cut face gets its own
/// ray if it is not connected to a whole face. Cost: O(n + k) for k pairs, and a ray per component.
/// Exact; deterministic.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "clean/arrange/planes.h"
#include "clean/arrange/winding_jumps.h"
#include "clean/exterior/ray_cast_front_winding.h"

namespace transformesh {

class RegionGrowingWinding {
 public:
  /// Keeps references to all arguments.
  RegionGrowingWinding(const WeldedMesh& welded, const Planes& planes, const WindingJumps& jumps,
                       const Surroundings* around = nullptr);

  /// Returns the winding number w in front of a face near its corner `i`. Returns nothing if other
  /// faces meet the corner, or if the face is not connected to a whole face.
  std::optional<int> at(Index face, Index i) const {
    const int w = front_[3 * face + i];
    return w == unknown ? std::nullopt : std::optional(w);
  }
  /// True if the face of a plane certainly has no part with winding number w < winding level in
  /// front and w >= winding level behind. False does not mean that the face has such a part.
  bool is_hidden(const Plane& plane, int winding_level) const;
  std::size_t rays() const { return rays_; }

 private:
  static constexpr int unknown = std::numeric_limits<int>::min();
  /// Changes of the winding number w in front along the edges of a cut face.
  struct CutFace {
    std::array<int, 3> along{};    ///< change of w from corner i to the next corner
    std::array<bool, 3> is_met{};  ///< true if other faces meet corner i
  };

  CutFace trace(const Plane& plane) const;
  void trace_meeting(const Meeting& meeting, Index face, CutFace& cut) const;
  bool is_complete(Index face) const { return !around_ || around_->is_complete[face]; }
  void leave_out_incomplete();
  void grow();
  void grow_from_cut_faces();
  int cast_at_corner(const RayCastFrontWinding& ray, Index face, Index i) const;
  Index seed_near(Index face) const;
  void spread(Index face, Index i, int w);
  void visit_corner(Index face, Index i, int w);
  void step_across(Index face, Index i, int w);

  const WeldedMesh& welded_;
  const Planes& planes_;
  const WindingJumps& jumps_;
  const Surroundings* around_;      ///< null for a whole mesh
  std::vector<CutFace> cut_faces_;  ///< one for each plane
  std::vector<Index> across_;       ///< opposite halfedge of each halfedge, or no_index
  std::vector<int> front_;          ///< winding number in front of the face at each corner
  std::vector<Index> stack_;        ///< corners whose neighbors have to be visited
  std::size_t rays_ = 0;
};

}  // namespace transformesh
