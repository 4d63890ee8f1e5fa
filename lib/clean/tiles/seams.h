/// Seams between meshes that are parts of one closed manifold: where border edges of one lie upon
/// those of another, their ends become one vertex. Cost: O(n log n) for n border edges, about 150
/// bytes for each; nothing is kept of other faces. Deterministic.
#pragma once

#include <vector>

#include "transformesh/mesh.h"

namespace transformesh {

class Seams {
 public:
  /// Adds the next mesh, which may be too large to be kept: its faces, and the position of each
  /// vertex. Throws InputError if an edge of the mesh has more than two faces.
  template <class PositionOf>
  void add(const std::vector<Face>& faces, std::size_t vertices, const PositionOf& position_of) {
    find_borders(faces, vertices);
    for (const Index v : border_vertices_) positions_.push_back(position_of(v));
    for (const BorderFace& face : border_faces_) apexes_.push_back(position_of(face.apex));
    keep_borders();
  }

  /// Joins the ends of edges after all meshes have been added. At an edge of more than two faces
  /// these pair across the inside (paper 3.3.2). Returns the number of border edges that are left.
  std::size_t join();

  /// Returns the vertex of the joined mesh for each vertex of a mesh. Vertices of all meshes come
  /// in their order, and joined ones are where the first of them is.
  std::vector<Index> numbers_of(std::size_t mesh) const;
  /// True if the vertex has this number already in an earlier place.
  std::vector<bool> is_repeated(std::size_t mesh) const;
  std::size_t vertex_count() const { return vertex_count_; }

 private:
  struct BorderFace {
    Index from, to;  ///< ends of the border halfedge, as border vertices of all meshes
    Index apex;      ///< the third corner, as a vertex of its mesh
  };
  struct Part {
    std::size_t vertices = 0;  ///< of the mesh
    Index first_border = 0;    ///< its first border vertex
    Index first_number = 0;    ///< number of its first vertex in the joined mesh
  };

  void find_borders(const std::vector<Face>& faces, std::size_t vertices);
  void keep_borders();
  void number_vertices();

  std::vector<Part> parts_;
  std::vector<Index> vertex_of_;  ///< per border vertex: the vertex of its mesh; ascending in each
  std::vector<Vec3> positions_;   ///< per border vertex
  std::vector<Face> halfedges_;   ///< on borders: from, to, 0
  std::vector<Vec3> apexes_;      ///< per border halfedge
  std::vector<Index> first_;      ///< per border vertex: the first that is joined with it
  std::vector<Index> number_;     ///< per border vertex: its vertex of the joined mesh
  std::vector<Index> border_vertices_;
  std::vector<BorderFace> border_faces_;
  std::size_t vertex_count_ = 0;
};

}  // namespace transformesh
