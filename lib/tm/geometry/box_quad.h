/// Four boxes side by side, tested at once: the node of the bounding volume hierarchy. Unused boxes
/// are NaN, which no comparison accepts.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <limits>

#include "tm/geometry/float_box.h"

namespace transformesh {

struct alignas(16) BoxQuad {
  float minimum[3][4];
  float maximum[3][4];

  FloatBox box(unsigned lane) const {
    return {{minimum[0][lane], minimum[1][lane], minimum[2][lane]},
            {maximum[0][lane], maximum[1][lane], maximum[2][lane]}};
  }

  void set(unsigned lane, const FloatBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      minimum[axis][lane] = box.minimum[axis];
      maximum[axis][lane] = box.maximum[axis];
    }
  }
};

inline constexpr float unused = std::numeric_limits<float>::quiet_NaN();
inline constexpr FloatBox unused_box{{unused, unused, unused}, {unused, unused, unused}};

/// Bit i is set where box i of the quad overlaps the box; touching counts.
inline unsigned overlap_mask(const BoxQuad& quad, const FloatBox& box) {
#ifdef __SSE2__
  __m128 overlap = _mm_castsi128_ps(_mm_set1_epi32(-1));
  for (int axis = 0; axis < 3; ++axis) {
    const __m128 is_below =
        _mm_cmple_ps(_mm_load_ps(quad.minimum[axis]), _mm_set1_ps(box.maximum[axis]));
    const __m128 is_above =
        _mm_cmple_ps(_mm_set1_ps(box.minimum[axis]), _mm_load_ps(quad.maximum[axis]));
    overlap = _mm_and_ps(overlap, _mm_and_ps(is_below, is_above));
  }
  return static_cast<unsigned>(_mm_movemask_ps(overlap));
#else
  unsigned mask = 0;
  for (unsigned lane = 0; lane < 4; ++lane) {
    bool overlap = true;
    for (int axis = 0; axis < 3; ++axis)
      overlap &= (quad.minimum[axis][lane] <= box.maximum[axis]) &
                 (box.minimum[axis] <= quad.maximum[axis][lane]);
    mask |= static_cast<unsigned>(overlap) << lane;
  }
  return mask;
#endif
}

/// Bit 4 * i + j is set where box i of the first overlaps box j of the second.
inline unsigned overlap_mask(const BoxQuad& first, const BoxQuad& second) {
  unsigned mask = 0;
  for (unsigned lane = 0; lane < 4; ++lane)
    mask |= overlap_mask(second, first.box(lane)) << (4 * lane);
  return mask;
}

}  // namespace transformesh
