/// An order in which boxes that follow each other lie close together: along a Hilbert curve through
/// their centers. Unlike the Morton curve it never jumps, so that any run of boxes is compact and
/// a tree can be packed from runs without looking at the boxes again.
/// Reference: Kamel & Faloutsos, "On packing R-trees", CIKM 1993; the curve after Hamilton &
/// Rau-Chaplin, "Compact Hilbert indices", Information Processing Letters 105(5), 2008.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/search/float_box.h"

namespace transformesh {

inline constexpr int hilbert_bits = 20;  ///< per axis

/// Position along the curve of a cell with coordinates below 2^hilbert_bits.
std::uint64_t hilbert_index(const std::array<std::uint32_t, 3>& cell);

/// The boxes in order along the curve; equal cells by index. Infinite bounds count as the largest
/// float. Cost: O(n) for boxes in distinct cells, O(n log n) at worst; deterministic.
std::vector<Index> hilbert_order(std::span<const FloatBox> boxes);
/// The same for points.
std::vector<Index> hilbert_order(std::span<const Vec3> points);

}  // namespace transformesh
