/// Tests which boxes of a quad (four boxes) overlap a box or the boxes of another quad; touching
/// counts as overlap.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "geometry/search/box_quad.h"

namespace transformesh {

/// Returns a mask whose bit i is set if box i of the quad (four boxes) overlaps `box`.
inline unsigned overlap_mask(const BoxQuad& quad, const FloatBox& box) {
#ifdef __SSE2__
  __m128 overlap = _mm_castsi128_ps(_mm_set1_epi32(-1));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const __m128 is_below = _mm_cmple_ps(_mm_load_ps(quad.minimum[axis].data()),
                                         _mm_set1_ps(box.max()[static_cast<Eigen::Index>(axis)]));
    const __m128 is_above = _mm_cmple_ps(_mm_set1_ps(box.min()[static_cast<Eigen::Index>(axis)]),
                                         _mm_load_ps(quad.maximum[axis].data()));
    overlap = _mm_and_ps(overlap, _mm_and_ps(is_below, is_above));
  }
  return static_cast<unsigned>(_mm_movemask_ps(overlap));
#else
  unsigned mask = 0;
  for (unsigned lane = 0; lane < 4; ++lane) {
    bool overlap = true;
    for (int axis = 0; axis < 3; ++axis)
      overlap &= (quad.minimum[axis][lane] <= box.max()[static_cast<Eigen::Index>(axis)]) &
                 (box.min()[static_cast<Eigen::Index>(axis)] <= quad.maximum[axis][lane]);
    mask |= static_cast<unsigned>(overlap) << lane;
  }
  return mask;
#endif
}

/// Returns four masks of the overlaps between the boxes of two quads. Bit i of mask r is set if box
/// i of the first quad overlaps box (i + r) % 4 of the second.
inline std::array<unsigned, 4> turned_overlap_masks(const BoxQuad& first, const BoxQuad& second) {
  std::array<unsigned, 4> masks{};
#ifdef __SSE2__
  struct Bounds {
    __m128 low, high;
  };
  std::array<Bounds, 3> turned;
  for (std::size_t axis = 0; axis < 3; ++axis)
    turned[axis] = {_mm_load_ps(second.minimum[axis].data()),
                    _mm_load_ps(second.maximum[axis].data())};
  for (std::size_t turn = 0; turn < 4; ++turn) {
    __m128 overlap = _mm_setzero_ps();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto& [low, high] = turned[axis];
      const __m128 is_below = _mm_cmple_ps(_mm_load_ps(first.minimum[axis].data()), high);
      const __m128 is_above = _mm_cmple_ps(low, _mm_load_ps(first.maximum[axis].data()));
      const __m128 both = _mm_and_ps(is_below, is_above);
      overlap = axis == 0 ? both : _mm_and_ps(overlap, both);
      low = _mm_shuffle_ps(low, low, _MM_SHUFFLE(0, 3, 2, 1));
      high = _mm_shuffle_ps(high, high, _MM_SHUFFLE(0, 3, 2, 1));
    }
    masks[turn] = static_cast<unsigned>(_mm_movemask_ps(overlap));
  }
#else
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned mask = overlap_mask(second, first.box(i));
    for (unsigned turn = 0; turn < 4; ++turn) masks[turn] |= (mask >> (i + turn) % 4 & 1) << i;
  }
#endif
  return masks;
}

/// Returns four masks of equal groups between the boxes of two quads. Bit i of mask r is set if box
/// i of the first quad has the group of box (i + r) % 4 of the second.
inline std::array<unsigned, 4> turned_group_masks(const GroupQuad& first, const GroupQuad& second) {
  std::array<unsigned, 4> masks{};
#ifdef __SSE2__
  const auto load = [](const GroupQuad& quad) {
    return _mm_load_si128(reinterpret_cast<const __m128i*>(quad.group.data()));
  };
  const __m128i own = load(first);
  const __m128i has_none = _mm_cmpeq_epi32(own, _mm_set1_epi32(-1));
  __m128i turned = load(second);
  for (unsigned& mask : masks) {
    const __m128i same = _mm_andnot_si128(has_none, _mm_cmpeq_epi32(own, turned));
    mask = static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(same)));
    turned = _mm_shuffle_epi32(turned, _MM_SHUFFLE(0, 3, 2, 1));
  }
#else
  for (unsigned turn = 0; turn < 4; ++turn)
    for (unsigned i = 0; i < 4; ++i) {
      const Index own = first.group[i];
      const bool is_same = own != no_index && own == second.group[(i + turn) % 4];
      masks[turn] |= static_cast<unsigned>(is_same) << i;
    }
#endif
  return masks;
}

}  // namespace transformesh
