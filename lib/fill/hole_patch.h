/// Computes patches for one hole. A plain patch is a triangulation of the border without additional
/// vertices. Its largest angle between normals of neighboring faces is as small as possible, and
/// its area is the least of such triangulations. A refined patch has additional vertices, as dense
/// as the vertices around the hole. A faired patch is a refined patch that continues the
/// surrounding surface smoothly. Reference: Liepa, "Filling holes in meshes", SGP 2003, as
/// implemented in CGAL. If the border has many edges, the triangulation is restricted to Delaunay
/// edges (Search::delaunay). Cost: that of the triangulation (hole_triangulation.h), nearly O(n log
/// n) for Search::delaunay with many edges. Deterministic.
#pragma once

#include <cstddef>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

enum class PatchKind { plain, refined, faired };

/// Triangles from which the best triangulation of the border is searched. With `all`, all triangles
/// of border points are used. With `delaunay`, and a border of more than 64 edges, only triangles
/// are used whose edges belong to the Delaunay tetrahedralization of the border points.
enum class Search { delaunay, all };

/// Callers use Search::all only for holes with at most this many edges, because its time grows with
/// the cube of the number of edges.
inline constexpr std::size_t most_edges_of_all = 200;

struct HolePatch {
  PatchKind kind = PatchKind::plain;
  /// Additional points; the first has the index after the last vertex of the mesh.
  std::vector<Vec3> points;
  std::vector<Face> faces;  ///< faces of the patch, oriented like the faces around the hole
};

struct HolePatches {
  /// The patches, the finest first; a patch without additional points is plain.
  std::vector<HolePatch> patches;
  bool are_of_all = false;  ///< true if Search::all would give the same patches
};

/// Returns a patch of each kind up to `finest` for the hole at a border halfedge. A kind is missing
/// if it cannot be computed for this hole. `around` is an oriented manifold with all faces within
/// two rings of the hole.
HolePatches patch_hole(const Mesh& around, Index border_halfedge, PatchKind finest, Search search);

/// Returns the patch with the faces `plain`, and patches of each kind up to `finest` made of it.
/// Returns no patch if `plain` is empty.
HolePatches finer_patches(const Mesh& around, const std::vector<Face>& plain, PatchKind finest);

}  // namespace transformesh
