/// A mesh as geometry sees it: equal positions are one point, whatever their indices, and faces
/// without area are left out. What touched such a face still meets, in equal or touching edges.
#pragma once

#include <vector>

#include "clean/intersect/face_directions.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/float_box.h"
#include "mesh/edges.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct WeldedMesh {
  std::vector<Vec3> points;                ///< all different
  std::vector<Index> vertex_of;            ///< the first mesh vertex at each point
  std::vector<Index> point_of;             ///< the point of each mesh vertex
  std::vector<Face> faces;                 ///< corners as points; none is degenerate
  std::vector<Index> face_of;              ///< the mesh face of each face; ascending
  std::vector<FaceDirections> directions;  ///< that each face looks
  std::vector<Index> first_copy;  ///< per face: the first with the same three points, in any order
  Edges edges;                    ///< of the faces
  /// Per halfedge, the one in the opposite direction along its edge if that has no others; else
  /// no_index.
  std::vector<Index> opposites;
  BoxFrame frame;  ///< of the points
  /// Per face its open component (clean/open/open_components.h), no_index in the closed part. Empty
  /// if all faces are closed.
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

/// Points come in the order of their first vertex, faces in that of the mesh. O(n); exact;
/// deterministic.
WeldedMesh weld(const Mesh& mesh);

/// Finds the edges of the faces, what is opposite, and the first copy of each, as `weld` does.
/// O(n).
void index_faces(WeldedMesh& welded);

}  // namespace transformesh
