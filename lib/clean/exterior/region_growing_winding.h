/// Region growing (paper 3.2) over a mesh before anything is cut. It finds the winding number w of
/// the closed part in front of every face, open ones included, near each corner. That is the same
/// in front of neighbors beside their common edge, and along an edge it changes where closed faces
/// intersect that. A ray fixes w in front of one whole face of each connected component
/// (paper 3.2.1). Of a part of a mesh, what is incomplete carries no w, and a face that is cut gets
/// a ray where no whole face is connected with it. Cost: O(n + k) for k pairs, and a ray per part.
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
  /// Keeps references.
  RegionGrowingWinding(const WeldedMesh& welded, const Planes& planes, const WindingJumps& jumps,
                       const Surroundings* around = nullptr);

  /// w in front of a face near its corner i. Nothing where other faces meet the corner, or where no
  /// whole face is connected with it.
  std::optional<int> at(Index face, Index i) const {
    const int w = front_[3 * face + i];
    return w == unknown ? std::nullopt : std::optional(w);
  }
  /// Whether the face of a plane has no part with w < winding level in front and w >= winding level
  /// behind it. May be false where that is not obvious.
  bool is_hidden(const Plane& plane, int winding_level) const;
  std::size_t rays() const { return rays_; }

 private:
  static constexpr int unknown = std::numeric_limits<int>::min();
  /// How w in front changes along the edges of a face that is cut.
  struct CutFace {
    std::array<int, 3> along{};    ///< from corner i to the next
    std::array<bool, 3> is_met{};  ///< other faces meet corner i
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
  std::vector<CutFace> cut_faces_;  ///< per plane
  std::vector<Index> across_;       ///< per halfedge
  std::vector<int> front_;          ///< per corner
  std::vector<Index> stack_;        ///< corners whose neighbors are to be visited
  std::size_t rays_ = 0;
};

}  // namespace transformesh
