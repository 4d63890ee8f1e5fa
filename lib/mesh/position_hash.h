/// Hash of a position. Equal positions have equal hashes; 0 and -0 are equal. The value is the same
/// on every machine.
#pragma once

#include <bit>
#include <cstdint>

#include "transformesh/mesh.h"

namespace transformesh {

inline std::uint64_t position_hash(const Vec3& p) {
  std::uint64_t h = 0x9e3779b97f4a7c15ULL;
  for (int i = 0; i < 3; ++i) {
    h ^= std::bit_cast<std::uint64_t>(p[i] + 0.0);  // adding 0 turns -0 into 0
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 32;
  }
  // Without a further multiplication, points that differ only in the sign of z would have hashes
  // with the same lower bits.
  h *= 0xc4ceb9fe1a85ec53ULL;
  return h ^ h >> 32;
}

}  // namespace transformesh
