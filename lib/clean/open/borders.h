/// Borders of a mesh, and the check whether it is oriented (paper 4.6). The criterion is the sum
/// along each edge: the number of faces that traverse the edge in one direction minus the number in
/// the other direction (stitch/orientation_check.h). Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct Borders {
  /// Loops of welded points, each in the direction of its faces.
  std::vector<std::vector<Index>> loops;
  bool is_oriented = true;  ///< true if no edge has a sum with an absolute value above one
};

/// Finds the boundary loops. A closed mesh has none. An edge with a surplus of n faces is in n
/// loops.
Borders find_borders(const WeldedMesh& welded, const Mesh& mesh);

/// Returns all mesh faces with points as corners. This includes faces without area, which the
/// welded mesh does not contain. Faces without area create no border: a face that refers to a point
/// twice traverses its edge in both directions.
std::vector<Face> faces_by_points(const WeldedMesh& welded, const Mesh& mesh);

/// Returns the borders of a mesh that can be cleaned. Throws InputError if the mesh is not
/// oriented; the error names the place, and its kind determines the remedy. Borders of a stitched
/// mesh that merely coincide are accepted.
Borders find_oriented_borders(const WeldedMesh& welded, const Mesh& mesh);

/// True if the vertex indices already represent the topology that equal positions imply. False if
/// faces are separate or have a seam, or if sheets share a vertex. Such a mesh has to be stitched,
/// even if nothing else changes.
bool is_stitched(const Mesh& mesh, const Borders& borders);

}  // namespace transformesh
