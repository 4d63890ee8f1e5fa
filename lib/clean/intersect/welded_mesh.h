/// Welded mesh: vertices with equal positions are one point, and faces without area are left out.
/// The neighbors of a face without area still meet each other, in equal or touching edges.
#pragma once

#include <vector>

#include "clean/intersect/face_directions.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/float_box.h"
#include "mesh/edges.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct WeldedMesh {
  std::vector<Vec3> points;      ///< distinct positions of all vertices
  std::vector<Index> vertex_of;  ///< first mesh vertex at each point
  std::vector<Index> point_of;   ///< point of each mesh vertex
  std::vector<Face> faces;       ///< corners are indices of points; no face is degenerate
  std::vector<Index> face_of;    ///< index in the mesh of each welded face; ascending
  /// Axis directions in which each face has positive projected area.
  std::vector<FaceDirections> directions;
  /// Per face: the first face with the same three points, in any order.
  std::vector<Index> first_copy;
  bool has_copies = false;  ///< true if any two faces have the same three points
  Edges edges;
  /// Per halfedge: the halfedge in the opposite direction, if the edge has no other halfedges;
  /// otherwise no_index.
  std::vector<Index> opposites;
  /// Translation and scale with which the bounding boxes of faces are converted to floats.
  BoxFrame frame;
  /// Per face its open component (clean/open/open_components.h), or no_index if the face is closed.
  /// The closed faces together traverse every edge equally often in both directions. Empty if all
  /// faces are closed.
  std::vector<Index> open_component{};

  bool is_open(Index face) const {
    return !open_component.empty() && open_component[face] != no_index;
  }
  Triangle triangle(Index face) const { return triangle_of(points, faces[face]); }
  FloatBox box(Index face) const { return box(triangle(face)); }
  FloatBox box(const Triangle& t) const {
    return frame.box(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]));
  }
};

/// Returns for each vertex the first vertex at the same position. O(n); parallel; deterministic.
std::vector<Index> find_first_vertices(const std::vector<Vec3>& positions);

/// Welds a mesh. Points are in the order of their first vertices, faces in mesh order. O(n); exact;
/// deterministic.
WeldedMesh weld(const Mesh& mesh);

/// Computes `edges`, `opposites` and `first_copy` from `faces`. O(n).
void index_faces(WeldedMesh& welded);

}  // namespace transformesh
