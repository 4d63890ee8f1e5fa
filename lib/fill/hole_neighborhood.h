/// Extracts the faces around a hole as a mesh, and interpolates columns for the patch of the hole.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// Faces around a hole as a mesh without columns.
struct HoleNeighborhood {
  Mesh mesh;
  std::vector<Index> vertices;  ///< index of each vertex in the whole mesh
};

/// Extracts `faces`, which ascend. Vertices keep their order. O(k log k).
HoleNeighborhood neighborhood_of(const Mesh& mesh, const std::vector<Index>& faces);

/// Returns the halfedge of the neighborhood that is `halfedge` of the whole mesh. `faces` are those
/// that were extracted.
Index halfedge_in_neighborhood(const std::vector<Index>& faces, Index halfedge);

/// Appends the faces around a vertex.
using FacesOfVertex = std::function<void(Index vertex, std::vector<Index>& faces)>;

/// The faces within two rings of these vertices, ascending. O(k log k).
std::vector<Index> faces_around(const Mesh& mesh, std::vector<Index> vertices,
                                const FacesOfVertex& append_faces);

/// The three nearest of these vertices, which are at least as many, nearer ones more.
RowBlend blend_of_nearest(const Mesh& mesh, const std::vector<Index>& vertices, const Vec3& point);

}  // namespace transformesh
