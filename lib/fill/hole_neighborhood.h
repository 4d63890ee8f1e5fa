/// Extracts the faces around a hole as a mesh, and interpolates columns for the patch of the hole.
#pragma once

#include <functional>
#include <vector>

#include "geometry/search/kd_tree.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// The faces around a hole as a mesh without attributes (columns).
struct HoleNeighborhood {
  Mesh mesh;
  std::vector<Index> vertices;  ///< index of each vertex in the whole mesh
};

/// Extracts `faces`, which must be in ascending order. Vertices keep their order. O(k log k).
HoleNeighborhood neighborhood_of(const Mesh& mesh, const std::vector<Index>& faces);

/// Returns the index that a halfedge of the whole mesh has in the neighborhood. `faces` are the
/// faces that were extracted.
Index halfedge_in_neighborhood(const std::vector<Index>& faces, Index halfedge);

/// Returns a neighborhood with one vertex for each umbrella, and the vertex of `mesh` for each of
/// its vertices. Umbrellas that are neighbors across the hole share a vertex. The border halfedges
/// of the hole are `loop`. A manifold does not change.
HoleNeighborhood with_other_holes_apart(const Mesh& mesh, const std::vector<Index>& loop);

/// Function that appends the faces at `vertex` to `faces`.
using FacesOfVertex = std::function<void(Index vertex, std::vector<Index>& faces)>;

/// Returns the faces within two rings of these vertices in ascending order. O(k log k).
std::vector<Index> faces_around(const Mesh& mesh, std::vector<Index> vertices,
                                const FacesOfVertex& append_faces);

/// Interpolates columns between the three of the given vertices that are nearest to a point,
/// weighted by inverse distance. Ties are broken by the lowest index. There must be at least three
/// vertices. O(log k) per point on usual data.
class BorderBlend {
 public:
  /// Keeps a reference to the mesh.
  BorderBlend(const Mesh& mesh, std::vector<Index> vertices);
  RowBlend operator()(const Vec3& point) const;

 private:
  const Mesh& mesh_;
  std::vector<Index> vertices_;  ///< ascending
  KdTree tree_;
};

}  // namespace transformesh
