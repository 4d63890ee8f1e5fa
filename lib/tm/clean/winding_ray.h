/// Winding numbers by rays whose every crossing is decided exactly (paper 2).
#pragma once

#include <vector>

#include "tm/clean/arrange.h"
#include "tm/geometry/bvh.h"

namespace transformesh {

class WindingRay {
 public:
  /// The faces of the soup, and fans that close the loops given.
  WindingRay(const Arrangement& arrangement, const std::vector<std::vector<Index>>& border_loops);

  /// w just in front of a piece. A ray that would graze an edge or a corner is replaced by one from
  /// another point of the piece, until one crosses faces in their interiors only.
  int in_front_of(const Piece& piece) const;

 private:
  struct Count {
    bool grazes = false;
    int winding = 0;
  };
  Count cast(const ExactPoint& origin, int axis, int direction) const;

  const Arrangement& arrangement_;
  std::vector<Triangle> triangles_;
  Bvh bvh_;
};

}  // namespace transformesh
