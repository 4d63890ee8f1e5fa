/// Four boxes stored as structure of arrays, which are tested together: a node of the bounding
/// volume hierarchy. Unused boxes are NaN, for which all comparisons are false.
#pragma once

#include <array>
#include <limits>

#include "geometry/search/float_box.h"

namespace transformesh {

struct alignas(16) BoxQuad {
  std::array<std::array<float, 4>, 3> minimum;
  std::array<std::array<float, 4>, 3> maximum;

  FloatBox box(unsigned lane) const {
    return {Eigen::Vector3f(minimum[0][lane], minimum[1][lane], minimum[2][lane]),
            Eigen::Vector3f(maximum[0][lane], maximum[1][lane], maximum[2][lane])};
  }

  void set(unsigned lane, const FloatBox& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      minimum[axis][lane] = box.min()[static_cast<Eigen::Index>(axis)];
      maximum[axis][lane] = box.max()[static_cast<Eigen::Index>(axis)];
    }
  }
};

/// For each of the four boxes of a BoxQuad, its group or no_index.
struct alignas(16) GroupQuad {
  std::array<Index, 4> group;
};

inline constexpr float unused = std::numeric_limits<float>::quiet_NaN();
inline FloatBox unused_box() {
  return {Eigen::Vector3f::Constant(unused), Eigen::Vector3f::Constant(unused)};
}

}  // namespace transformesh
