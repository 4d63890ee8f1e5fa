/// Roles of vertices, which decide how they may move and merge. A vertex inside a smooth part is
/// free. A vertex on a line (a border or a chain of sharp edges) is bound to it. A vertex at which
/// lines meet, end or turn is fixed.
#pragma once

#include "remesh/halfedges/editable_mesh.h"

namespace transformesh {

enum class VertexRole { free, on_line, fixed };

/// Marks the edges between faces whose normals differ by more than the feature angle. Marks no edge
/// if the angle is >= 180.
void mark_features(EditableMesh& mesh, double feature_angle_deg);

/// True if the edge is part of a line: a border or a feature (a sharp edge).
inline bool is_line(const EditableMesh& mesh, Index halfedge) {
  return mesh.is_border(halfedge) || mesh.is_feature(halfedge);
}

class VertexRoles {
 public:
  VertexRoles(const EditableMesh& mesh, bool keep_border)
      : mesh_(mesh),
        has_lines_(mesh.has_borders() || mesh.has_features()),
        keep_border_(keep_border) {}
  VertexRole operator[](Index vertex) const { return has_lines_ ? role(vertex) : VertexRole::free; }
  /// Returns the two neighbors of the vertex on its line (a border or a chain of sharp edges). Pre:
  /// the role is on_line.
  std::array<Index, 2> line_neighbors(Index vertex) const;
  /// True if the ends of the edge may be merged without damage to borders and sharp edges.
  bool may_merge(Index halfedge) const;
  bool keeps_border() const { return keep_border_; }

 private:
  VertexRole role(Index vertex) const;

  const EditableMesh& mesh_;
  bool has_lines_;
  bool keep_border_;
};

}  // namespace transformesh
