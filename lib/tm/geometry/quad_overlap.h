/// Which boxes of a quad overlap a box or the boxes of another quad; touching counts.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "tm/geometry/box_quad.h"

namespace transformesh {

/// Bit i is set where box i of the quad overlaps the box.
inline unsigned overlap_mask(const BoxQuad& quad, const FloatBox& box) {
#ifdef __SSE2__
  __m128 overlap = _mm_castsi128_ps(_mm_set1_epi32(-1));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const __m128 is_below =
        _mm_cmple_ps(_mm_load_ps(quad.minimum[axis].data()), _mm_set1_ps(box.maximum[axis]));
    const __m128 is_above =
        _mm_cmple_ps(_mm_set1_ps(box.minimum[axis]), _mm_load_ps(quad.maximum[axis].data()));
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
