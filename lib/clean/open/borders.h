/// Finds the borders of a mesh, and checks whether it is oriented (paper 4.6). Both depend on the
/// sum along each edge: the number of faces that traverse the edge in one direction minus the
/// number in the opposite direction (stitch/orientation_check.h). Cost: O(n log n). Deterministic.
#pragma once

#include <vector>

#include "clean/intersect/welded_mesh.h"

namespace transformesh {

struct Borders {
  /// Boundary loops, as indices of welded points in the direction in which the faces traverse the
  /// border.
  std::vector<std::vector<Index>> loops;
  /// True if along each edge the numbers of faces in both directions differ by at most 1.
  bool is_oriented = true;
};

/// Finds the boundary loops. A closed mesh has none. An edge is in n loops if n more faces traverse
/// it in one direction than in the other.
Borders find_borders(const WeldedMesh& welded, const Mesh& mesh);

/// True if the vertex indices define an oriented manifold, and border edges coincide only because
/// several sheets (sets of connected faces) end at another sheet, or because bodies touch. Cleaning
/// and plane cuts create such meshes. False if the surface continues across coincident borders, or
/// if reversing sheets makes the mesh oriented.
bool is_oriented_by_indices(const WeldedMesh& welded, const Mesh& mesh);

/// True if the faces of two halfedges with equal ends lie on each other near the edge. Then they
/// are not neighbors in one surface, but belong to bodies that touch, or end at the same border.
bool overlap(const Mesh& mesh, Index halfedge, Index other);

/// Returns all mesh faces with welded points as corners. This includes faces without area, which
/// the welded mesh does not contain. A face without area that refers to a point twice creates no
/// border, because it traverses the same edge in both directions.
std::vector<Face> faces_by_points(const WeldedMesh& welded, const Mesh& mesh);

/// Returns the borders of a mesh. Throws InputError if the mesh is not oriented, and thus cannot be
/// cleaned. The error names the place, and the kind of error tells which remedy works. In an
/// oriented manifold by vertex indices, borders of different sheets may have the same positions;
/// such a mesh counts as oriented.
Borders find_oriented_borders(const WeldedMesh& welded, const Mesh& mesh);

/// True if the vertex indices define an oriented manifold with exactly the borders that equal
/// positions imply. False if neighboring faces have separate vertices at equal positions, or if
/// sheets share a vertex. Such a mesh has to be stitched, even if nothing else changes.
bool is_stitched(const Mesh& mesh, const Borders& borders);

}  // namespace transformesh
