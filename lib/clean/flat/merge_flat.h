/// Merges flat faces: coplanar faces become as few triangles as their outline needs.
///
/// Vertices inside flat regions (flat_regions.h) and on straight edges (flat_outlines.h) are
/// removed. Each region becomes a constrained Delaunay triangulation of its outlines. No vertex
/// moves.
///
/// Guarantees for an oriented manifold: the result is an oriented manifold of the same topology. No
/// new face intersects another face or has no area; a region that would violate this keeps its
/// faces. New faces have the columns of the faces that they replace, which are equal. Both surfaces
/// are within `displacement` of each other. Untouched faces and vertices keep their order; new
/// faces follow. The columns of removed vertices are lost. Deterministic. Cost: O(n log n).
/// Reference: Hinker & Hansen, "Geometric optimization", IEEE Visualization 1993.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "transformesh/control.h"

namespace transformesh {

/// Tolerance of flat regions, in spacings of the coordinates. The smallest of 1, 4, 16, 64, 256 and
/// 4096 with which merging succeeds in all regions of 100 test capsules
/// (docs/design/flat-faces.md).
inline constexpr double flat_spacings = 64;

struct MergeFlatResult {
  std::size_t regions = 0;  ///< regions with fewer faces than before
  /// Regions that keep their faces: new faces would intersect a face, or there is no triangulation.
  std::size_t kept_regions = 0;
  std::size_t removed_faces = 0;  ///< number of faces before minus number after
  double displacement = 0;
};

/// Merges the flat regions that contain a face marked in `wanted`. The tolerance is `spacings`
/// spacings of type `coordinate`, in which positions are stored. Vertices marked in `fixed` stay;
/// `fixed` may be empty.
MergeFlatResult merge_flat(Mesh& mesh, std::vector<char> wanted, double spacings, Scalar coordinate,
                           const Progress& progress, const std::vector<char>& fixed = {});

}  // namespace transformesh
