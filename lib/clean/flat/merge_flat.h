/// Merges flat faces: connected faces in one plane are replaced by as few triangles as their
/// outline needs.
///
/// Vertices inside flat regions (flat_regions.h) and on straight edges (flat_outlines.h) are
/// removed. Each region becomes a constrained Delaunay triangulation of its outlines. No vertex
/// moves.
///
/// Guarantees for an oriented manifold: the result is an oriented manifold of the same topology. No
/// new face intersects another face, and each new face has an area. A region for which this is not
/// possible keeps its faces. New faces have the columns of the faces that they replace, which are
/// equal. The surfaces before and after are within `displacement` of each other. Unchanged faces
/// and vertices keep their order; new faces follow. The columns of removed vertices are lost.
/// Deterministic. Cost: O(n log n). Reference: Hinker & Hansen, "Geometric optimization", IEEE
/// Visualization 1993.
#pragma once

#include <vector>

#include "clean/rounding/displacement.h"
#include "transformesh/control.h"

namespace transformesh {

/// Tolerance of flat regions, in spacings of floating-point numbers at the coordinates. The value
/// is the smallest of 1, 4, 16, 64, 256 and 4096 with which merging succeeds in all regions of 100
/// test capsules (docs/design/flat-faces.md).
inline constexpr double flat_spacings = 64;

struct MergeFlatResult {
  std::size_t regions = 0;  ///< number of regions with fewer faces than before
  /// Number of regions that keep their faces, because new faces would intersect a face, or because
  /// there is no triangulation.
  std::size_t kept_regions = 0;
  std::size_t removed_faces = 0;  ///< number of faces before minus number after
  double displacement = 0;
};

/// Merges the flat regions that contain a face with a nonzero `wanted` entry. The tolerance is
/// `spacings` times the spacing of numbers of type `coordinate`, in which positions are stored.
/// Vertices with a nonzero `fixed` entry stay; `fixed` may be empty.
MergeFlatResult merge_flat(Mesh& mesh, std::vector<char> wanted, double spacings, Scalar coordinate,
                           const Progress& progress, const std::vector<char>& fixed = {});

}  // namespace transformesh
