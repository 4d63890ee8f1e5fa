/// Links: where dozens of faces share a corner or an edge, all their boxes overlap there. Faces
/// around a vertex meet beyond it just where the arcs meet that they cut out of a small sphere
/// around it (its link); faces at an edge, where they leave it in one direction. So each face gets
/// a box around its arc or direction, for its crowded corners and edges: the faces around one
/// vertex whose boxes are apart share nothing but what they share as indices. Arithmetic in
/// doubles; boxes are wider than its errors. Coordinates beyond that get boxes that are apart from
/// none. Cost: O(n); where nothing is crowded, a count of corners.
#pragma once

#include <span>

#include "geometry/search/float_box.h"

namespace transformesh {

/// Around part of the link of one vertex or edge.
struct LinkBox {
  Index link = no_index;
  FloatBox box{};
};

/// Of one face, or of several faces that have these links in common; unused boxes come last.
using LinkBoxes = std::array<LinkBox, 3>;

struct SimplexLinks {
  std::vector<Index>
      row_of;  ///< in `boxes`, per face; no_index for most; empty if nothing is crowded
  std::vector<LinkBoxes> boxes;

  bool empty() const { return boxes.empty(); }
  const LinkBoxes* of(Index face) const {
    return empty() || row_of[face] == no_index ? nullptr : &boxes[row_of[face]];
  }
};

/// A corner or an edge with more faces is crowded.
inline constexpr Index most_uncrowded = 32;

/// The links of faces, none of which names a point twice.
SimplexLinks find_simplex_links(std::span<const Vec3> points, std::span<const Face> faces);

/// Whether two faces, or any two of two sets, meet in nothing but what they share. Without links
/// nothing is known.
bool are_apart(const LinkBoxes& a, const LinkBoxes& b);
inline bool are_apart(const LinkBoxes* a, const LinkBoxes* b) {
  return a != nullptr && b != nullptr && are_apart(*a, *b);
}

/// What the faces of both sets have in common: the links of both, with boxes around both.
LinkBoxes common_links(const LinkBoxes& a, const LinkBoxes& b);

}  // namespace transformesh
