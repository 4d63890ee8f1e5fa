/// Measures of a mesh that need no edge search.
#pragma once

#include <span>

#include "transformesh/mesh.h"

namespace transformesh {

/// Returns the positions of the vertices that faces use, in the order of the vertices.
std::vector<Vec3> used_positions(const Mesh& mesh);

/// Returns the exponent of the power of two that scales extreme coordinates to about 1. Returns 0
/// for usual coordinates, so that their results are not rounded differently.
int extreme_exponent(const Mesh& mesh);
/// Returns the mesh with coordinates divided by the power of two with this exponent, without
/// columns.
Mesh scaled_down(const Mesh& mesh, int exponent);

/// Returns the mean of the corners of a face.
inline Vec3 face_middle(const Mesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[face];
  return mesh.positions[a] / 3 + mesh.positions[b] / 3 + mesh.positions[c] / 3;
}

/// Returns the unit vector in the plane of a face, perpendicular to a halfedge, into the face.
/// The face must have an area.
Vec3 direction_into_face(const Mesh& mesh, Index halfedge);

/// Returns a third of the area of the faces around each vertex.
std::vector<double> vertex_areas(const Mesh& mesh);

/// Lengths over all halfedges; an edge of two faces counts twice.
struct HalfedgeLengths {
  double mean = 0;
  double maximum = 0;
  /// Mean length of the halfedges that start or end at each vertex; 0 if there are none.
  std::vector<double> vertex_mean;
};
HalfedgeLengths halfedge_lengths(const Mesh& mesh);

/// Returns the normal of one vertex as vertex_normals() does, given its faces in ascending order.
Vec3 vertex_normal(const Mesh& mesh, Index vertex, std::span<const Index> faces);

}  // namespace transformesh
