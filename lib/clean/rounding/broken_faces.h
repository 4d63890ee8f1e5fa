/// Finds and removes faces that intersect others, or have no area, because exact points were
/// rounded to stored coordinates (paper 4.3). New faces are those that are not whole faces of the
/// input.
#pragma once

#include <vector>

#include "clean/intersect/disjoint_faces.h"
#include "clean/stitch/assemble.h"
#include "transformesh/intersect.h"

namespace transformesh {

/// Broken faces of a mesh: faces that intersect another face, or have no area, because of rounding.
struct BrokenFaces {
  /// Broken faces, ascending; only intersections with at least one new face count.
  std::vector<Index> faces;
  /// Intersecting pairs with at least one new face. These are all pairs, because other faces do not
  /// intersect each other.
  std::vector<FacePair> pairs;
  /// Faces that were searched, without those that intersect another face. No two of them intersect.
  std::vector<Index> disjoint;
};

/// Finds the broken faces. Faces that are whole faces of the input must not intersect each other.
/// Two faces of `known` are not tested with each other. Cost: O(n), and O(m log m) for the m faces
/// that are searched: those whose boxes overlap that of a new face.
BrokenFaces find_broken_faces(const Assembly& assembly, const DisjointFaces& known = {});

/// Returns `faces` and all faces that share a corner with them, in ascending order.
std::vector<Index> with_faces_around(const Mesh& mesh, const std::vector<Index>& faces);

/// Returns the number of connected sets into which `faces` are divided. Faces that share a corner
/// are connected.
std::size_t count_places(const Mesh& mesh, const std::vector<Index>& faces);

/// Merges vertices with equal positions in the faces. Drops faces that refer to a vertex twice, and
/// pairs of coincident faces with opposite orientation, if their corners are corners of new faces.
/// A closed mesh stays closed. Returns true if a face was dropped.
bool drop_collapsed_faces(Assembly& assembly);

}  // namespace transformesh
