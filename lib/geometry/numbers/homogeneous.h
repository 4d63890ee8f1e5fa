/// Planes and the points that they define in homogeneous coordinates, made of coordinates
/// themselves and of no differences: where numbers of very different magnitudes meet, these would
/// lose the smaller ones. In every sum all products differ, so that balls lose no digits but where
/// the configuration is close to a degenerate one. For numbers of any kind.
/// Reference: Stolfi, "Oriented projective geometry", 1991 (Pluecker coordinates).
#pragma once

#include "geometry/numbers/number_vector.h"

namespace transformesh {

/// The point x / w.
template <class Number>
struct HomogeneousPoint {
  NumberVector<Number> x;
  Number w;
};

/// The points p with normal . p = offset.
template <class Number>
struct HomogeneousPlane {
  NumberVector<Number> normal;
  Number offset;
};

template <class Number>
NumberVector<Number> number_vector(const Vec3& p) {
  return {Number(p[0]), Number(p[1]), Number(p[2])};
}

/// a x b + b x c + c x a, given b x c.
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

/// The normal alone.
template <class Number>
NumberVector<Number> homogeneous_normal(const Triangle& t) {
  const auto b = number_vector<Number>(t[1]), c = number_vector<Number>(t[2]);
  return sum_of_crosses(number_vector<Number>(t[0]), b, c, cross(b, c));
}

/// Where line uv crosses the plane.
template <class Number>
HomogeneousPoint<Number> homogeneous_point(const Vec3& u, const Vec3& v,
                                           const HomogeneousPlane<Number>& plane) {
  const auto way = difference<Number>(v, u);
  const auto turned =
      cross(plane.normal, cross(number_vector<Number>(u), number_vector<Number>(v)));
  const auto x = [&](std::size_t i) { return plane.offset * way[i] + turned[i]; };
  return {{x(0), x(1), x(2)}, dot(plane.normal, way)};
}

/// Where three planes meet.
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

/// Times the weight, +: the point is on the side that the triangle's normal points to.
template <class Number>
Number height_over(const Triangle& t, const HomogeneousPoint<Number>& point) {
  const HomogeneousPlane<Number> plane = homogeneous_plane<Number>(t);
  return dot(plane.normal, point.x) - plane.offset * point.w;
}

}  // namespace transformesh
