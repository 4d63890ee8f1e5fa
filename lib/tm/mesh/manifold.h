/// Whether a mesh is an oriented 2-manifold, with or without borders, and where it is not.
#pragma once

#include <string>
#include <vector>

#include "tm/mesh/mesh.h"

namespace transformesh {

struct ManifoldReport {
  std::vector<Index> nonmanifold_edges;     ///< a halfedge of each edge with three or more faces
  std::vector<Index> misoriented_edges;     ///< a halfedge of each edge whose two faces run alike
  std::vector<Index> nonmanifold_vertices;  ///< vertices whose faces are not one fan or disk
  std::vector<Index> border_halfedges;      ///< halfedges without a face across
  std::vector<Index> degenerate_faces;  ///< two corners of the same index or position, or zero area
  std::vector<Index> isolated_vertices;  ///< used by no face
  std::size_t boundary_loops = 0;

  bool is_manifold() const { return nonmanifold_edges.empty() && nonmanifold_vertices.empty(); }
  bool is_oriented() const { return misoriented_edges.empty(); }
  bool is_closed() const { return border_halfedges.empty(); }
};

/// Vertices are the same when their indices are. Zero area is decided exactly: collinear corners.
ManifoldReport check_manifold(const Mesh& mesh);

/// The first problem in words, with face and vertex ids and coordinates; empty if there is none of
/// manifoldness, orientation and, on request, closedness.
std::string describe_problem(const Mesh& mesh, const ManifoldReport& report, bool closed);

}  // namespace transformesh
