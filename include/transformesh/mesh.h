/// The data model: indexed triangles with named columns per vertex and per face. Plain data without
/// invariants: each algorithm documents the properties that it needs (closed, oriented, manifold)
/// and builds its own connectivity. A halfedge has the index 3 * face + i: the edge of the face
/// from its corner i to its corner (i + 1) % 3.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "transformesh/columns.h"

namespace transformesh {

using Vec3 = Eigen::Vector3d;
using Index = std::uint32_t;
using Face = std::array<Index, 3>;  ///< corners, counter-clockwise seen from outside

inline constexpr Index no_index = 0xffffffffU;

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Face> faces;
  Columns vertex_columns;  ///< each column has positions.size() rows
  Columns face_columns;    ///< each column has faces.size() rows
};

/// An obstacle that displace(), remesh() and decimate() keep a surface away from.
struct KeepOutOptions {
  const Mesh* surface = nullptr;  ///< the obstacle; null if there is none
  double gap = 0;                 ///< least distance from the obstacle; input units; > 0
};

/// True if a face has a repeated vertex index, and so is not a triangle.
inline bool is_collapsed(const Face& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// Returns the vertex at which a halfedge starts.
inline Index halfedge_source(const Mesh& mesh, Index halfedge) {
  return mesh.faces[halfedge / 3][halfedge % 3];
}
/// Returns the next, or the previous, halfedge around the same face.
inline Index next_halfedge(Index halfedge) {
  return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1;
}
inline Index previous_halfedge(Index halfedge) {
  return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1;
}
inline Index halfedge_target(const Mesh& mesh, Index halfedge) {
  return halfedge_source(mesh, next_halfedge(halfedge));
}

}  // namespace transformesh
