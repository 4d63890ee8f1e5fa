/// Positions in extended precision, for measures of parts that are as close as doubles are apart.
#pragma once

#include <Eigen/Geometry>

#include "tm/mesh/mesh.h"

namespace transformesh {

using WidePoint = Eigen::Matrix<long double, 3, 1>;

inline WidePoint wide(const Vec3& p) { return p.cast<long double>(); }

}  // namespace transformesh
