/// What rounding all but unites becomes one: the step between rounds of repair (settle.h) that lets
/// films and slivers thinner than a distance collapse, so that cleaning removes them.
///
/// Where a vertex is that close to an edge or to the inside of a face, the edge or the face is
/// split there at the vertex; where two edges pass each other that closely, both are split at one
/// new vertex between them. Edges of one face whose ends are then on another become edges there, so
/// that two sheets of a film end in the same triangles. A sliver whose corner splits its own
/// opposite edge vanishes. No vertex moves. Equal positions are one point: what is closed stays
/// closed. Deterministic. Cost: O(k log k) for k faces of usual shape. Reference for the plane:
/// Hobby, "Practical segment intersection with finite precision output", Computational Geometry
/// 13(4), 1999.
#pragma once

#include <vector>

#include "tm/clean/stitch/assemble.h"

namespace transformesh {

/// The faces, and those whose boxes are that close to theirs; ascending.
std::vector<Index> with_near_faces(const Mesh& mesh, const std::vector<Index>& faces,
                                   double distance);

struct Closeness {
  double distance = 0;    ///< where coordinates are largest
  bool is_local = false;  ///< along axes where those of both parts are smaller, it is less, as is
                          ///< the spacing of numbers
};

/// Only what is on the faces named is compared. New positions are in numbers of that type. Does
/// nothing and returns false where too many of them are close to each other, as where hundreds
/// pass through one point.
bool unite_close_parts(Assembly& assembly, const std::vector<Index>& faces,
                       const Closeness& closeness, Scalar coordinate);

}  // namespace transformesh
