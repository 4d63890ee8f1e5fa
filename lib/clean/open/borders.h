/// Where the surface of a mesh ends, and whether it has an outside at all: what open and
/// misoriented input needs before it can be cleaned (paper 4.6). Along an edge counts the sum of
/// the faces that traverse it in one direction, less those in the other
/// (stitch/orientation_check.h). Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct Borders {
  std::vector<std::vector<Index>> loops;  ///< of welded points, each in the direction of its faces
  bool is_oriented = true;                ///< no edge has a sum of more than one
};

/// A closed mesh has no loops. An edge at which n faces are left over is in n loops.
Borders find_borders(const WeldedMesh& welded, const Mesh& mesh);

/// All mesh faces by points. Faces without area, which the welded mesh lacks, make no border: those
/// that name a point twice traverse their edge in both directions.
std::vector<Face> faces_by_points(const WeldedMesh& welded, const Mesh& mesh);

/// The borders of a mesh that can be cleaned. Throws InputError for one that is not oriented,
/// saying where and what mends it, unless borders of a stitched mesh merely lie upon each other.
Borders find_oriented_borders(const WeldedMesh& welded, const Mesh& mesh);

/// Whether indices say what positions say: not so where faces are separate or have a seam, or where
/// sheets share a vertex. Such a mesh is to be stitched, though nothing else need change.
bool is_stitched(const Mesh& mesh, const Borders& borders);

}  // namespace transformesh
