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

/// Bounding box of the directions from a vertex or an edge into a face. `link` is the number of the
/// vertex or edge.
struct LinkBox {
  Index link = no_index;
  FloatBox box{};
};

/// Link boxes of a face: at most three, for its crowded corners and edges. For several faces, only
/// those for corners and edges that all of these faces have. Unused entries are last.
using LinkBoxes = std::array<LinkBox, 3>;

struct SimplexLinks {
  /// For each face, the index of its link boxes in `boxes`, or no_index, as for most faces. Empty
  /// if there are no crowded corners.
  std::vector<Index> row_of;
  std::vector<LinkBoxes> boxes;

  bool empty() const { return boxes.empty(); }
  const LinkBoxes* of(Index face) const {
    return empty() || row_of[face] == no_index ? nullptr : &boxes[row_of[face]];
  }
};

/// A corner or edge with more faces than this is crowded, and gets link boxes. A choice: with a
/// lower limit, link boxes take more memory; with a higher limit, more pairs of faces are tested.
inline constexpr Index most_uncrowded = 32;

/// Returns a box around the arc that a face cuts out of the unit sphere around its first corner.
/// The box overlaps all others if a coordinate is out of range or two corners coincide.
FloatBox arc_box(const Vec3& corner, const Vec3& a, const Vec3& b);

/// Returns the link boxes of all faces with crowded corners. No face may refer to a point twice.
SimplexLinks find_simplex_links(std::span<const Vec3> points, std::span<const Face> faces);

/// True if link boxes prove that two faces, or any two faces of two sets, meet only in shared
/// vertices and edges. False if there are no common links.
bool are_apart(const LinkBoxes& a, const LinkBoxes& b);
inline bool are_apart(const LinkBoxes* a, const LinkBoxes* b) {
  return a != nullptr && b != nullptr && are_apart(*a, *b);
}

/// Returns link boxes for the corners and edges that both arguments have in common. Each box
/// contains the boxes of both arguments.
LinkBoxes common_links(const LinkBoxes& a, const LinkBoxes& b);

}  // namespace transformesh
