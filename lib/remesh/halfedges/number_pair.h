/// Pairs of numbers for vector instructions. Results are the same as for single numbers. The types
/// are an extension of GCC and Clang.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <cmath>

namespace transformesh {

using NumberPair = double __attribute__((vector_size(16)));
/// A pair of truth values: all bits set, or none.
using MaskPair = long long __attribute__((vector_size(16)));

inline NumberPair twice(double number) { return NumberPair{number, number}; }
inline NumberPair lesser(NumberPair a, NumberPair b) { return b < a ? b : a; }
inline NumberPair greater(NumberPair a, NumberPair b) { return a < b ? b : a; }
inline bool any(MaskPair mask) { return (mask[0] | mask[1]) != 0; }
inline bool all(MaskPair mask) { return (mask[0] & mask[1]) != 0; }
/// Returns the two middle numbers of a[0], a[1], b[0], b[1].
inline NumberPair middle(NumberPair a, NumberPair b) { return NumberPair{a[1], b[0]}; }

inline NumberPair square_roots(NumberPair squares) {
#ifdef __SSE2__
  return _mm_sqrt_pd(squares);
#else
  return NumberPair{std::sqrt(squares[0]), std::sqrt(squares[1])};
#endif
}

/// Two vectors. Sums have the order of Eigen, so that results are the same.
struct VectorPair {
  NumberPair x, y, z;

  NumberPair dot(const VectorPair& other) const {
    return x * other.x + (y * other.y + z * other.z);
  }
  NumberPair squared() const { return dot(*this); }
  VectorPair cross(const VectorPair& other) const {
    return {y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x};
  }
  VectorPair operator+(const VectorPair& other) const {
    return {x + other.x, y + other.y, z + other.z};
  }
  VectorPair operator-(const VectorPair& other) const {
    return {x - other.x, y - other.y, z - other.z};
  }
};
template <class Vector>
VectorPair twice_vector(const Vector& vector) {
  return {twice(vector.x()), twice(vector.y()), twice(vector.z())};
}
inline VectorPair middle(const VectorPair& a, const VectorPair& b) {
  return {middle(a.x, b.x), middle(a.y, b.y), middle(a.z, b.z)};
}

/// Two normals with their squared lengths.
struct NormalPair {
  VectorPair normal;
  NumberPair squared;
};

}  // namespace transformesh
