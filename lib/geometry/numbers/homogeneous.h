/// Planes and their intersection points in homogeneous coordinates, for any number type. The
/// formulas use coordinates instead of differences. If magnitudes differ strongly, differences
/// would lose the smaller numbers. All products in a sum are distinct, so balls lose digits only if
/// the configuration is nearly degenerate. Reference: Stolfi, "Oriented projective geometry", 1991
/// (Pluecker coordinates).
#pragma once

#include "geometry/numbers/number_vector.h"

namespace transformesh {

/// The point x / w.
template <class Number>
struct HomogeneousPoint {
  NumberVector<Number> x;
  Number w;
};

/// A plane: the points p with dot(normal, p) = offset.
template <class Number>
struct HomogeneousPlane {
  NumberVector<Number> normal;
  Number offset;
};

template <class Number>
NumberVector<Number> number_vector(const Vec3& p) {
  return {Number(p[0]), Number(p[1]), Number(p[2])};
}

/// Returns the normal a x b + b x c + c x a of the triangle abc; `bc` is b x c.
template <class Number>
NumberVector<Number> sum_of_crosses(const NumberVector<Number>& a, const NumberVector<Number>& b,
                                    const NumberVector<Number>& c, const NumberVector<Number>& bc) {
  const auto ab = cross(a, b), ca = cross(c, a);
  const auto sum = [&](std::size_t i) { return ab[i] + bc[i] + ca[i]; };
  return {sum(0), sum(1), sum(2)};
}

template <class Number>
HomogeneousPlane<Number> homogeneous_plane(const Triangle& t) {
  const auto a = number_vector<Number>(t[0]), b = number_vector<Number>(t[1]),
             c = number_vector<Number>(t[2]);
  const auto bc = cross(b, c);
  return {sum_of_crosses(a, b, c, bc), dot(a, bc)};
}

template <class Number>
NumberVector<Number> homogeneous_normal(const Triangle& t) {
  const auto b = number_vector<Number>(t[1]), c = number_vector<Number>(t[2]);
  return sum_of_crosses(number_vector<Number>(t[0]), b, c, cross(b, c));
}

/// Returns the intersection of the line uv with the plane.
template <class Number>
HomogeneousPoint<Number> homogeneous_point(const Vec3& u, const Vec3& v,
                                           const HomogeneousPlane<Number>& plane) {
  const auto way = difference<Number>(v, u);
  const auto turned =
      cross(plane.normal, cross(number_vector<Number>(u), number_vector<Number>(v)));
  const auto x = [&](std::size_t i) { return plane.offset * way[i] + turned[i]; };
  return {{x(0), x(1), x(2)}, dot(plane.normal, way)};
}

template <class Number>
HomogeneousPoint<Number> homogeneous_point(const HomogeneousPlane<Number>& f,
                                           const HomogeneousPlane<Number>& g,
                                           const HomogeneousPlane<Number>& h) {
  const auto gh = cross(g.normal, h.normal), hf = cross(h.normal, f.normal),
             fg = cross(f.normal, g.normal);
  const auto x = [&](std::size_t i) {
    return f.offset * gh[i] + g.offset * hf[i] + h.offset * fg[i];
  };
  return {{x(0), x(1), x(2)}, dot(f.normal, gh)};
}

/// Returns the signed height of a point above the plane, multiplied by the weights of both.
/// Positive on the side of the normal.
template <class Number>
Number height_over(const Triangle& t, const HomogeneousPoint<Number>& point) {
  const HomogeneousPlane<Number> plane = homogeneous_plane<Number>(t);
  return dot(plane.normal, point.x) - plane.offset * point.w;
}

}  // namespace transformesh
