/// Unites parts of a mesh that are closer than a distance: the step between rounds of repair
/// (snap_rounding.h) that lets films and slivers thinner than that collapse, so that cleaning
/// removes them.
///
/// Where a vertex is that close to an edge or to the interior of a face, the edge or the face is
/// split at the vertex. Where two edges pass each other that closely, both are split at one new
/// vertex between them. Edges of one face whose ends are then on another become edges there, so
/// that two sheets of a film end in the same triangles. A sliver whose corner splits its own
/// opposite edge vanishes. No vertex moves. Equal positions are one point: what is closed stays
/// closed. Deterministic. Cost: O(k log k) for k faces of usual shape. Reference for the plane,
/// where this is snap rounding with vertices as hot pixels: Hobby, "Practical segment intersection
/// with finite precision output", Computational Geometry 13(4), 1999.
#pragma once

#include <vector>

#include "tm/clean/stitch/assemble.h"

namespace transformesh {

/// The faces, and all others whose boxes are that close to theirs; ascending.
std::vector<Index> with_near_faces(const Mesh& mesh, const std::vector<Index>& faces,
                                   double distance);

struct Closeness {
  double distance = 0;  ///< at the largest coordinate of the mesh
  bool is_local =
      false;  ///< it shrinks with the coordinates, along each axis, as their spacing does
};

/// Unites parts of the faces named. New positions are rounded to numbers of the type `coordinate`.
/// Does nothing and returns false where too many faces are close to each other, as where hundreds
/// pass through one point.
bool unite_close_parts(Assembly& assembly, const std::vector<Index>& faces,
                       const Closeness& closeness, Scalar coordinate);

}  // namespace transformesh
