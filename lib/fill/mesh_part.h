/// What lies around a hole: a part of a mesh by itself, and columns of what is put there.
#pragma once

#include <functional>
#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

/// A part of a mesh without columns, and which vertices of that mesh its own are.
struct MeshPart {
  Mesh mesh;
  std::vector<Index> vertices;
};

/// Those faces, which ascend; vertices come in the order of the mesh. O(k log k).
MeshPart part_of(const Mesh& mesh, const std::vector<Index>& faces);

/// The halfedge of the part that is this one of the mesh; `faces` are those of the part.
Index halfedge_in_part(const std::vector<Index>& faces, Index halfedge);

/// Appends the faces around a vertex.
using FacesOfVertex = std::function<void(Index vertex, std::vector<Index>& faces)>;

/// The faces within two rings of these vertices, ascending. O(k log k).
std::vector<Index> faces_around(const Mesh& mesh, std::vector<Index> vertices,
                                const FacesOfVertex& append_faces);

/// The three nearest of these vertices, which are at least as many, nearer ones more.
RowBlend blend_of_nearest(const Mesh& mesh, const std::vector<Index>& vertices, const Vec3& point);

}  // namespace transformesh
