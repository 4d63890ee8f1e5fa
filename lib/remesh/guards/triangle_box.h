/// Bounding boxes of triangles.
#pragma once

#include "mesh/triangle.h"

namespace transformesh {

inline Vec3 lowest(const Triangle& triangle) {
  return triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
}
inline Vec3 highest(const Triangle& triangle) {
  return triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
}

inline bool boxes_touch(const Triangle& first, const Triangle& second) {
  return (lowest(first).array() <= highest(second).array()).all() &&
         (lowest(second).array() <= highest(first).array()).all();
}

}  // namespace transformesh
