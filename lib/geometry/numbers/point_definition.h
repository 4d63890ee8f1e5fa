/// Definitions of points: as vertices of a mesh, or as intersections of its edges and faces.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

#include "transformesh/mesh.h"

namespace transformesh {

/// Definition of a point. Points with equal definitions are equal. The order of edges, of their
/// ends, and of faces does not matter. Free points and means have no definition.
struct PointDefinition {
  enum class Kind : std::uint8_t { given, free, line_plane, line_line, three_planes, mean };

  Kind kind = Kind::free;
  /// Indices whose meaning depends on `kind`. For `given`: a vertex. For `line_plane`: ends u and v
  /// of an edge, and a face. For `line_line`: ends u and v, and ends x and y, of two edges. For
  /// `three_planes`: three faces.
  std::array<Index, 4> indices{};

  static PointDefinition given(Index vertex) { return {Kind::given, {vertex}}; }
  /// The intersection of edge uv with the plane of a face; the two must intersect in one point.
  static PointDefinition line_plane(Index u, Index v, Index face) {
    return {Kind::line_plane, {std::min(u, v), std::max(u, v), face}};
  }
  /// The intersection of two coplanar edges that are not parallel.
  static PointDefinition line_line(Index u, Index v, Index x, Index y) {
    if (u > v) std::swap(u, v);
    if (x > y) std::swap(x, y);
    if (u < x || (u == x && v < y)) return {Kind::line_line, {u, v, x, y}};
    return {Kind::line_line, {x, y, u, v}};
  }
  /// The intersection of the planes of three faces, which must be a single point.
  static PointDefinition three_planes(Index f, Index g, Index h) {
    std::array<Index, 3> faces{f, g, h};
    std::sort(faces.begin(), faces.end());
    return {Kind::three_planes, {faces[0], faces[1], faces[2]}};
  }

  bool is_known() const { return kind != Kind::free && kind != Kind::mean; }
  bool operator==(const PointDefinition&) const = default;
  /// Orders by kind, then by indices. The libc++ of clang 14 has no `operator<=>` of std::array.
  bool operator<(const PointDefinition& other) const {
    return std::tie(kind, indices) < std::tie(other.kind, other.indices);
  }
};

struct PointDefinitionHash {
  std::size_t operator()(const PointDefinition& definition) const {
    auto hash = static_cast<std::uint64_t>(definition.kind);
    for (const Index i : definition.indices) {
      hash = (hash ^ i) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 29U;
    }
    return hash;
  }
};

}  // namespace transformesh
