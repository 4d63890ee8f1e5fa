/// Checks whether a mesh is an oriented 2-manifold, with or without borders, and lists the places
/// where it is not. Vertices are identified by index, not by position. All lists are ascending.
/// Faces without area do not matter for topology; degenerate_faces() in geometry finds them. Cost:
/// O(n); deterministic.
#pragma once

#include <string>
#include <vector>

#include "transformesh/errors.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct ManifoldReport {
  std::vector<Index> nonmanifold_edges;  ///< a halfedge of each edge with three or more faces
  /// A halfedge of each edge whose two faces traverse it in the same direction.
  std::vector<Index> misoriented_edges;
  std::vector<Index> nonmanifold_vertices;  ///< vertices whose faces are not one umbrella or disk
  std::vector<Index> collapsed_faces;       ///< faces with a repeated vertex index
  std::vector<Index> border_halfedges;      ///< halfedges without an opposite face
  std::vector<Index> isolated_vertices;     ///< vertices that no face uses
  std::size_t boundary_loops = 0;
  /// Number of border edges that coincide with others (touching_borders.h).
  std::size_t touching_borders = 0;

  bool is_manifold() const {
    return nonmanifold_edges.empty() && nonmanifold_vertices.empty() && collapsed_faces.empty();
  }
  bool is_oriented() const { return misoriented_edges.empty(); }
  bool is_closed() const { return border_halfedges.empty(); }
};

ManifoldReport check_manifold(const Mesh& mesh);

/// Returns the first problem of manifoldness, of orientation, and of closedness if `closed` is set.
/// The message has face and vertex indices and coordinates; it is empty if there is no problem.
Problem manifold_problem(const Mesh& mesh, const ManifoldReport& report, bool closed);

}  // namespace transformesh
