/// Computes a point from its definition as a fraction, in any number type. Formulas use differences
/// from the origin of the fraction, so that balls (numbers with an error bound) and intervals stay
/// narrow.
#pragma once

#include <span>
#include <stdexcept>

#include "geometry/numbers/number_vector.h"
#include "geometry/numbers/point_definition.h"
#include "geometry/numbers/predicates.h"

namespace transformesh {

/// A point, represented as origin + numerator / denominator. The origin is a mesh vertex.
template <class Number>
struct PointFraction {
  Vec3 origin;
  NumberVector<Number> numerator;
  Number denominator;
};

template <class Number>
PointFraction<Number> along_edge(const Vec3& u, const Vec3& v, const Number& from_u,
                                 const Number& total) {
  NumberVector<Number> step = difference<Number>(v, u);
  for (Number& coordinate : step) coordinate = coordinate * from_u;
  return {u, step, total};
}

/// Returns the intersection of the edge uv with the plane. This point divides the edge in the ratio
/// of the heights of u and v above the plane.
template <class Number>
PointFraction<Number> line_plane_fraction(const Vec3& u, const Vec3& v, const Triangle& plane) {
  const NumberVector<Number> n = normal<Number>(plane);
  const Number height_u = dot(n, difference<Number>(plane[0], u));
  const Number climb = dot(n, difference<Number>(v, u));
  return along_edge(u, v, height_u, climb);
}

/// Returns the intersection of the edges uv and xy. Its parameter on uv, in the projection, is
/// ((x - u) x (y - x)) / ((v - u) x (y - x)).
template <class Number>
PointFraction<Number> line_line_fraction(const Vec3& u, const Vec3& v, const Vec3& x, const Vec3& y,
                                         PlaneProjection p) {
  const auto turn = [&](const NumberVector<Number>& a, const NumberVector<Number>& b) {
    const auto i = static_cast<std::size_t>(p.u);
    const auto j = static_cast<std::size_t>(p.v);
    return Number(a[i] * b[j] - a[j] * b[i]);
  };
  const NumberVector<Number> other = difference<Number>(y, x);
  return along_edge(u, v, turn(difference<Number>(x, u), other),
                    turn(difference<Number>(v, u), other));
}

/// Returns the intersection of three planes by Cramer's rule. Coordinates are relative to a corner
/// of the first plane's triangle, so that the offset of this plane is zero.
template <class Number>
PointFraction<Number> three_planes_fraction(const Triangle& f, const Triangle& g,
                                            const Triangle& h) {
  const NumberVector<Number> nf = normal<Number>(f);
  const NumberVector<Number> ng = normal<Number>(g);
  const NumberVector<Number> nh = normal<Number>(h);
  const Number dg = dot(ng, difference<Number>(g[0], f[0]));
  const Number dh = dot(nh, difference<Number>(h[0], f[0]));
  const NumberVector<Number> hf = cross(nh, nf);
  const NumberVector<Number> fg = cross(nf, ng);
  NumberVector<Number> numerator;
  for (std::size_t i = 0; i < 3; ++i) numerator[i] = dg * hf[i] + dh * fg[i];
  return {f[0], numerator, dot(ng, hf)};
}

/// Returns a projection in which the two edges are not parallel. Two edges that intersect in one
/// point span a plane, and any projection that is not along this plane is valid.
inline PlaneProjection projection_of_edges(const Vec3& u, const Vec3& v, const Vec3& x,
                                           const Vec3& y) {
  PlaneProjection projection = projection_of({u, v, x});
  if (orient2d(u, v, x, projection) == 0) projection = projection_of({u, v, y});
  return projection;
}

/// Returns the point as a fraction. The definition must name edges or faces.
template <class Number>
PointFraction<Number> fraction_of(const PointDefinition& definition,
                                  std::span<const Vec3> positions, std::span<const Face> faces) {
  const auto& d = definition.indices;
  const auto plane = [&](int i) { return triangle_of(positions, faces[d[i]]); };
  switch (definition.kind) {
    case PointDefinition::Kind::line_plane:
      return line_plane_fraction<Number>(positions[d[0]], positions[d[1]], plane(2));
    case PointDefinition::Kind::line_line: {
      const Vec3 &a = positions[d[0]], &b = positions[d[1]];
      const Vec3 &x = positions[d[2]], &y = positions[d[3]];
      return line_line_fraction<Number>(a, b, x, y, projection_of_edges(a, b, x, y));
    }
    case PointDefinition::Kind::three_planes:
      return three_planes_fraction<Number>(plane(0), plane(1), plane(2));
    default:
      throw std::logic_error("this point carries its coordinates from the start");
  }
}

}  // namespace transformesh
