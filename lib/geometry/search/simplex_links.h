/// Simplex links: if many faces share a corner or an edge, all their boxes overlap there. Faces
/// around a vertex meet elsewhere if and only if their arcs on a small sphere around the vertex
/// (its link) meet. Faces at an edge meet elsewhere if they leave the edge in the same direction.
/// Therefore each face gets a box around its arc or direction, for each of its crowded corners and
/// edges. Faces around one vertex with disjoint boxes share only common vertices and edges.
/// Arithmetic in doubles; boxes include the rounding errors. Coordinates out of range get boxes
/// that overlap all others. Cost: O(n); if no corner is crowded, only corners are counted.
#pragma once

#include <span>

#include "geometry/search/float_box.h"

namespace transformesh {

/// Box around a part of the link of a vertex or an edge.
struct LinkBox {
  Index link = no_index;
  FloatBox box{};
};

/// Boxes around the parts of links that a face covers: at most one for each of its crowded corners
/// and edges. For several faces, only links that all of them have. Unused entries are last.
using LinkBoxes = std::array<LinkBox, 3>;

struct SimplexLinks {
  /// Row in `boxes` of each face, or no_index for most faces. Empty if there are no crowded
  /// corners.
  std::vector<Index> row_of;
  std::vector<LinkBoxes> boxes;

  bool empty() const { return boxes.empty(); }
  const LinkBoxes* of(Index face) const {
    return empty() || row_of[face] == no_index ? nullptr : &boxes[row_of[face]];
  }
};

/// A corner or edge with more faces than this is crowded. A choice: a lower limit gives more links,
/// which take memory; a higher limit leaves more pairs of boxes.
inline constexpr Index most_uncrowded = 32;

/// Returns a box around the arc that a face cuts out of the unit sphere around its first corner.
/// The box overlaps all others if a coordinate is out of range or two corners coincide.
FloatBox arc_box(const Vec3& corner, const Vec3& a, const Vec3& b);

/// Returns the link boxes of faces. No face may refer to a point twice.
SimplexLinks find_simplex_links(std::span<const Vec3> points, std::span<const Face> faces);

/// True if two faces, or any two faces of two sets, certainly meet only in shared vertices and
/// edges. False without links.
bool are_apart(const LinkBoxes& a, const LinkBoxes& b);
inline bool are_apart(const LinkBoxes* a, const LinkBoxes* b) {
  return a != nullptr && b != nullptr && are_apart(*a, *b);
}

/// Returns the links that both sets have in common, with boxes around the parts of both.
LinkBoxes common_links(const LinkBoxes& a, const LinkBoxes& b);

}  // namespace transformesh
