/// Points and segments in rational arithmetic, for oracles that share no code with the predicates
/// of the library.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "transformesh/mesh.h"

namespace transformesh::test {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;
using RationalTriangle = std::array<RationalPoint, 3>;

inline RationalPoint exact(const Vec3& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}

inline RationalTriangle exact_triangle(const Mesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {exact(mesh.positions[a]), exact(mesh.positions[b]), exact(mesh.positions[c])};
}

inline RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Rational dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline RationalPoint normal(const RationalTriangle& t) {
  return cross(minus(t[1], t[0]), minus(t[2], t[0]));
}

inline bool is_zero(const RationalPoint& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// True if the point lies on the triangle or its border.
inline bool contains(const RationalTriangle& t, const RationalPoint& p) {
  const RationalPoint n = normal(t);
  if (dot(n, minus(p, t[0])) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(n, cross(minus(t[(i + 1) % 3], t[i]), minus(p, t[i]))) < 0) return false;
  }
  return true;
}

/// True if the point lies on the segment or at its ends.
inline bool contains(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
  const RationalPoint along = minus(b, a), to = minus(p, a);
  return is_zero(cross(along, to)) && dot(along, to) >= 0 && dot(along, to) <= dot(along, along);
}

/// Returns the point at which a segment intersects the plane of a triangle; empty if they are
/// parallel or do not meet.
inline std::optional<RationalPoint> crossing(const RationalPoint& a, const RationalPoint& b,
                                             const RationalTriangle& t) {
  const RationalPoint n = normal(t), along = minus(b, a);
  const Rational climb = dot(n, along);
  if (climb == 0) return std::nullopt;
  const Rational share = dot(n, minus(t[0], a)) / climb;
  if (share < 0 || share > 1) return std::nullopt;
  return RationalPoint{a[0] + share * along[0], a[1] + share * along[1], a[2] + share * along[2]};
}

/// Returns the intersection of two coplanar segments; empty if they are parallel or do not meet.
inline std::optional<RationalPoint> crossing(const RationalPoint& a, const RationalPoint& b,
                                             const RationalPoint& c, const RationalPoint& d) {
  const RationalPoint u = minus(b, a), v = minus(d, c), n = cross(u, v);
  if (is_zero(n)) return std::nullopt;
  const Rational s = dot(cross(minus(c, a), v), n) / dot(n, n);
  const Rational t = dot(cross(minus(c, a), u), n) / dot(n, n);
  if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
  return RationalPoint{a[0] + s * u[0], a[1] + s * u[1], a[2] + s * u[2]};
}

/// Returns the common point of three planes by Cramer's rule; empty if there is not exactly one.
inline std::optional<RationalPoint> crossing(const RationalTriangle& f, const RationalTriangle& g,
                                             const RationalTriangle& h) {
  const RationalPoint nf = normal(f), ng = normal(g), nh = normal(h);
  const Rational determinant = dot(nf, cross(ng, nh));
  if (determinant == 0) return std::nullopt;
  const Rational df = dot(nf, f[0]), dg = dot(ng, g[0]), dh = dot(nh, h[0]);
  const RationalPoint gh = cross(ng, nh), hf = cross(nh, nf), fg = cross(nf, ng);
  RationalPoint p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = (df * gh[i] + dg * hf[i] + dh * fg[i]) / determinant;
  return p;
}

}  // namespace transformesh::test
