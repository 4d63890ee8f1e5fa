/// Merges flat faces: those that lie in one plane become as few triangles as their outline needs.
///
/// Vertices inside of flat regions (flat_regions.h) and on straight edges (flat_outlines.h) go, and
/// each region becomes a constrained Delaunay triangulation of what is left. No vertex moves.
/// Guaranteed for an oriented manifold: the result is one of the same topology. No new face
/// intersects another one or is without area: a region of which a face would keeps its faces. New
/// faces have the columns of the faces that they replace, which are equal. The two surfaces are
/// within `displacement` of each other. Untouched faces and vertices keep their order, new faces
/// follow. Not preserved: the columns of vertices that go. Deterministic. Cost: O(n log n).
/// Reference: Hinker & Hansen, "Geometric optimization", IEEE Visualization 1993.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "transformesh/control.h"

namespace transformesh {

/// How far corners may be from the plane of a flat region, in spacings of the coordinates
/// (docs/design/flat-faces.md).
inline constexpr double flat_spacings = 64;

struct MergeFlatResult {
  std::size_t regions = 0;        ///< that have fewer faces now
  std::size_t kept_regions = 0;   ///< that would intersect something, or have no triangulation
  std::size_t removed_faces = 0;  ///< the difference of their numbers
  double displacement = 0;
};

/// Merges the flat regions that hold a face marked in `wanted`: within `spacings` of the numbers of
/// type `coordinate`, in which positions are stored. Vertices marked in `fixed` stay; it may be
/// empty.
MergeFlatResult merge_flat(Mesh& mesh, std::vector<char> wanted, double spacings, Scalar coordinate,
                           const Progress& progress, const std::vector<char>& fixed = {});

}  // namespace transformesh
