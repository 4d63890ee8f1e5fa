/// Sorts boxes such that consecutive boxes are close together: along a Hilbert curve through their
/// centers. Unlike the Morton curve, the Hilbert curve has no jumps. Hence each run of boxes is
/// compact, and a tree can be packed from runs. References: Kamel & Faloutsos, "On packing
/// R-trees", CIKM 1993; for the curve, Hamilton & Rau-Chaplin, "Compact Hilbert indices",
/// Information Processing Letters 105(5), 2008.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/search/float_box.h"

namespace transformesh {

inline constexpr int hilbert_bits = 20;  ///< number of bits of each cell coordinate

/// Returns the position of a cell along the Hilbert curve. The coordinates of the cell must be
/// below 2^hilbert_bits.
std::uint64_t hilbert_index(const std::array<std::uint32_t, 3>& cell);

/// Returns the indices of the boxes in order along the Hilbert curve. Boxes whose centers are in
/// the same cell are sorted by index. Infinite bounds are replaced by the largest float. Cost: O(n)
/// for boxes in distinct cells, O(n log n) in the worst case; deterministic.
std::vector<Index> hilbert_order(std::span<const FloatBox> boxes);
/// Returns the indices of the points in order along the Hilbert curve.
std::vector<Index> hilbert_order(std::span<const Vec3> points);

}  // namespace transformesh
