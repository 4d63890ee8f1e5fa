/// Joins seams between meshes that are parts of one closed manifold: the ends of coincident border
/// edges of different meshes become one vertex. Cost: O(n log n) for n border edges, and about 150
/// bytes of memory for each. Faces without border edges are not stored. Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class Seams {
 public:
  /// Adds the next mesh, which may be too large to be stored, by its faces and vertex positions.
  /// Only its border edges are stored. Throws InputError if an edge of the mesh has more than two
  /// faces.
  template <class PositionOf>
  void add(const std::vector<Face>& faces, std::size_t vertices, const PositionOf& position_of) {
    find_borders(faces, vertices);
    for (const Index v : border_vertices_) positions_.push_back(position_of(v));
    for (const BorderFace& face : border_faces_) apexes_.push_back(position_of(face.apex));
    keep_borders();
  }

  /// Joins the ends of edges after all meshes are added. At edges of more than two faces, two faces
  /// are joined if the inside of the mesh is between them (paper 3.3.2). Returns the number of
  /// remaining border edges.
  std::size_t join();

  /// Returns for each vertex of mesh number `mesh` its index in the joined mesh. Vertices that
  /// became one vertex have the index of the first of them. Otherwise vertices keep their order.
  std::vector<Index> numbers_of(std::size_t mesh) const;
  /// Returns for each vertex of mesh number `mesh` whether it was merged into an earlier vertex.
  std::vector<bool> is_repeated(std::size_t mesh) const;
  std::size_t vertex_count() const { return vertex_count_; }

 private:
  struct BorderFace {
    Index from, to;  ///< ends of the border halfedge, as vertex indices of its mesh
    Index apex;  ///< third corner of the face at the border halfedge, as vertex index of its mesh
  };
  struct Part {
    std::size_t vertices = 0;  ///< number of vertices of the mesh
    Index first_border = 0;    ///< index of the first border vertex of the mesh in `vertex_of_`
    Index first_number = 0;    ///< index of the mesh's first vertex in the joined mesh
  };

  void find_borders(const std::vector<Face>& faces, std::size_t vertices);
  void keep_borders();
  void number_vertices();

  std::vector<Part> parts_;
  /// For each border vertex of all meshes, its vertex index in its own mesh. Ascending within each
  /// mesh.
  std::vector<Index> vertex_of_;
  std::vector<Vec3> positions_;  ///< position of each border vertex
  /// Border halfedges of all meshes, as (from, to, 0) with indices of border vertices.
  std::vector<Face> halfedges_;
  /// For each border halfedge, the position of the third corner of its face.
  std::vector<Vec3> apexes_;
  /// For each border vertex, the first border vertex that is merged with it.
  std::vector<Index> first_;
  std::vector<Index> number_;  ///< index of each border vertex in the joined mesh
  std::vector<Index> border_vertices_;
  std::vector<BorderFace> border_faces_;
  std::size_t vertex_count_ = 0;
};

}  // namespace transformesh
