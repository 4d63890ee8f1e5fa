/// Whether a mesh is an oriented 2-manifold, with or without borders, and where it is not.
/// Vertices are the same when their indices are. Lists ascend. Faces without area are no matter of
/// topology: degenerate_faces() in geometry finds them. Cost: O(n); deterministic.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace transformesh {

struct ManifoldReport {
  std::vector<Index> nonmanifold_edges;  ///< a halfedge of each edge with three or more faces
  std::vector<Index> misoriented_edges;  ///< a halfedge of each edge whose two faces traverse it in
                                         ///< the same direction
  std::vector<Index> nonmanifold_vertices;  ///< vertices whose faces are not one umbrella or disk
  std::vector<Index> collapsed_faces;       ///< faces that name a vertex twice: no triangles
  std::vector<Index> border_halfedges;      ///< halfedges without a face across
  std::vector<Index> isolated_vertices;     ///< used by no face
  std::size_t boundary_loops = 0;
  std::size_t touching_borders = 0;  ///< border edges that lie upon others (touching_borders.h)

  bool is_manifold() const {
    return nonmanifold_edges.empty() && nonmanifold_vertices.empty() && collapsed_faces.empty();
  }
  bool is_oriented() const { return misoriented_edges.empty(); }
  bool is_closed() const { return border_halfedges.empty(); }
};

ManifoldReport check_manifold(const Mesh& mesh);

/// The first problem in words, with face and vertex ids and coordinates; empty if there is none of
/// manifoldness, orientation and, on request, closedness.
std::string describe_problem(const Mesh& mesh, const ManifoldReport& report, bool closed);

}  // namespace transformesh
