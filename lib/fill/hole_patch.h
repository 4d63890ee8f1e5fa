/// Patches for one hole: the triangulation of its border with the smallest dihedral angles and then
/// area; the same refined until its triangles are as dense as those around; and that faired, so
/// that it continues them smoothly. Reference: Liepa, "Filling holes in meshes", SGP 2003, as CGAL
/// has it. Cost: that of the triangulation (hole_triangulation.h), nearly O(n log n) for
/// Search::delaunay of many edges. Deterministic.
#pragma once

#include <cstddef>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

enum class PatchKind { plain, refined, faired };

/// Among which triangles: beyond 64 edges those whose edges are of the Delaunay tetrahedra of the
/// border; or always all.
enum class Search { delaunay, all };

/// Search::all is not asked for holes with more edges.
inline constexpr std::size_t most_edges_of_all = 200;

struct HolePatch {
  PatchKind kind = PatchKind::plain;
  std::vector<Vec3> points;  ///< new ones: the vertices behind those of the mesh
  std::vector<Face> faces;   ///< oriented as the faces around
};

struct HolePatches {
  std::vector<HolePatch> patches;  ///< The finest first. One without new points is plain.
  bool are_of_all = false;         ///< They are those of Search::all.
};

/// For the hole beside the border halfedge of an oriented manifold that holds all faces within two
/// rings of it: patches of all kinds up to the finest. Kinds that cannot be made are left out.
HolePatches patch_hole(const Mesh& around, Index border_halfedge, PatchKind finest, Search search);

}  // namespace transformesh
