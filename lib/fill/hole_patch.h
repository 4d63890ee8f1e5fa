/// Patches for one hole. A plain patch is the triangulation of the border with the least dihedral
/// angles and then the least area. A refined patch has additional vertices, as dense as the
/// vertices around the hole. A faired patch continues the surrounding surface smoothly. Reference:
/// Liepa, "Filling holes in meshes", SGP 2003, as implemented in CGAL. Triangulations with many
/// border edges are restricted to Delaunay edges (Search::delaunay). Cost: that of the
/// triangulation (hole_triangulation.h), nearly O(n log n) for Search::delaunay with many edges.
/// Deterministic.
#pragma once

#include <cstddef>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

enum class PatchKind { plain, refined, faired };

/// Triangles among which a patch is searched. With `delaunay`, a border of more than 64 edges gets
/// only triangles whose edges belong to the Delaunay tetrahedralization of the border.
enum class Search { delaunay, all };

/// Callers use Search::all only for holes with at most this many edges, since its cost is cubic.
inline constexpr std::size_t most_edges_of_all = 200;

struct HolePatch {
  PatchKind kind = PatchKind::plain;
  std::vector<Vec3> points;  ///< new points; indexed after the vertices of the mesh
  std::vector<Face> faces;   ///< faces, oriented like the faces around the hole
};

struct HolePatches {
  std::vector<HolePatch> patches;  ///< the finest patch first; a patch without new points is plain
  bool are_of_all = false;         ///< true if Search::all gives the same patches
};

/// Returns patches of all kinds up to `finest` for the hole at a border halfedge. Kinds that cannot
/// be made are missing. `around` is an oriented manifold with all faces within two rings of the
/// hole.
HolePatches patch_hole(const Mesh& around, Index border_halfedge, PatchKind finest, Search search);

}  // namespace transformesh
