/// Vectors of any number type, for predicates that are evaluated in several types: intervals, balls
/// (numbers with an error bound) and exact numbers.
#pragma once

#include <array>

#include "mesh/triangle.h"

namespace transformesh {

template <class Number>
using NumberVector = std::array<Number, 3>;

template <class Number>
NumberVector<Number> difference(const Vec3& p, const Vec3& origin) {
  return {Number(p[0]) - Number(origin[0]), Number(p[1]) - Number(origin[1]),
          Number(p[2]) - Number(origin[2])};
}

template <class Number>
NumberVector<Number> cross(const NumberVector<Number>& a, const NumberVector<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number>
Number dot(const NumberVector<Number>& a, const NumberVector<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
NumberVector<Number> normal(const Triangle& t) {
  return cross<Number>(difference<Number>(t[1], t[0]), difference<Number>(t[2], t[0]));
}

}  // namespace transformesh
