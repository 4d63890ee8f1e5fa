/// A surface that what moves is kept away from: an option of remesh(), decimate() and displace().
#pragma once

#include "mesh/mesh.h"

namespace transformesh {

struct KeepOutOptions {
  const Mesh* surface = nullptr;  ///< to stay away from; none
  double gap = 0;                 ///< input units; > 0 where there is a surface
};

}  // namespace transformesh
