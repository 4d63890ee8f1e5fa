/// Winding numbers by rays whose every crossing is decided exactly (paper 2).
#pragma once

#include <functional>
#include <vector>

#include "tm/clean/arrange/arrange.h"
#include "tm/clean/exterior/close_borders.h"
#include "tm/geometry/bvh.h"

namespace transformesh {

class WindingRay {
 public:
  /// The faces of the soup, and what closes its borders. About so many `rays` will be cast: where
  /// they are few, all faces are asked each time, which costs less than ordering them.
  WindingRay(const Arrangement& arrangement, const BorderClosure& closure, std::size_t rays);

  /// w just in front of a piece. A ray that would graze an edge or a corner is replaced by one from
  /// another point of the piece, until one crosses faces in their interiors only.
  int in_front_of(const Piece& piece) const;

 private:
  struct Count {
    bool grazes = false;
    int winding = 0;
  };
  Count cast(const ExactPoint& origin, int axis, int direction, Index cluster) const;
  Triangle triangle(Index i) const;
  void visit_overlaps(const Vec3& low, const Vec3& high,
                      const std::function<bool(Index)>& visit) const;
  void limit_sheets(const BorderClosure& closure);

  const Arrangement& arrangement_;
  std::vector<Triangle> closure_;  ///< triangles that follow the soup's
  std::vector<Index> cluster_of_;  ///< per point: what hangs together with it; only for sheets
  std::vector<Index> only_for_;    ///< per triangle: the one cluster that it counts for, if any
  Bvh bvh_;                        ///< empty where all are asked
};

}  // namespace transformesh
