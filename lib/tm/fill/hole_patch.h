/// A patch for one hole: the triangulation of its border with the smallest dihedral angles and then
/// area, refined until its triangles are as dense as those around, and faired so that it continues
/// them smoothly. Reference: Liepa, "Filling holes in meshes", SGP 2003, as CGAL has it. The patch
/// may cross itself and the mesh. Cost: O(n^3) for n border edges, but nearly O(n log n) for
/// Search::delaunay of many edges. Deterministic, but for this: of triangulations that are equally
/// good to the last digit Search::delaunay takes for many edges the one that memory holds first.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

enum class PatchKind { plain, refined, faired };

/// Among which triangles: beyond 64 edges those of the Delaunay tetrahedra of the border, where
/// they hold a patch; or always all.
enum class Search { delaunay, all };

/// Beyond it Search::all takes seconds.
inline constexpr std::size_t most_edges_of_all = 200;

struct HolePatch {
  std::vector<Vec3> points;  ///< new ones: the vertices behind those of the mesh
  std::vector<Face> faces;   ///< oriented as the faces around
};

/// For the hole beside the border halfedge of an oriented manifold that holds all faces within two
/// rings of it. Nothing where no patch of that kind is found.
std::optional<HolePatch> patch_hole(const Mesh& around, Index border_halfedge, PatchKind kind,
                                    Search search);

}  // namespace transformesh
